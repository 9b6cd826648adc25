// Loaded into RViz ahead of Xlib, by sieve_rviz. Ogre creates RViz's window on one connection to the X server
// and Mesa asks for its size on another; nothing makes the server do the one before the other. Where it asks
// first, the call fails, Mesa goes on with what happens to be on the stack for a size (168 by 0 pixels), and
// llvmpipe draws past the end of a buffer of 0 bytes: RViz crashes a moment after its start, in one start of
// ten beside two busy programs. At RViz's end the window is gone before the last picture: the same again.
#include <X11/Xlib.h>
#include <dlfcn.h>

namespace
{
/// Xlib's own function of a name, behind ours.
template <typename Function>
Function* ofXlib(Function*, const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}
}  // namespace

/// Returns when the window exists for other connections, too.
extern "C" Window XCreateWindow(Display* display, Window parent, int x, int y, unsigned width,
                                unsigned height, unsigned border_width, int depth, unsigned window_class,
                                Visual* visual, unsigned long mask, XSetWindowAttributes* attributes)
{
  static const auto CREATE = ofXlib(&XCreateWindow, "XCreateWindow");
  const Window window = CREATE(display, parent, x, y, width, height, border_width, depth, window_class,
                               visual, mask, attributes);
  XSync(display, False);
  return window;
}

/// A window that does not exist has one pixel, the least that one can have.
extern "C" Status XGetGeometry(Display* display, Drawable drawable, Window* root, int* x, int* y,
                               unsigned* width, unsigned* height, unsigned* border_width, unsigned* depth)
{
  static const auto GET = ofXlib(&XGetGeometry, "XGetGeometry");
  const Status found = GET(display, drawable, root, x, y, width, height, border_width, depth);
  if (found == 0)
    *width = *height = 1;
  return found;
}
