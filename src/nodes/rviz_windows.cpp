// sieve_rviz loads this library into RViz before Xlib. It works around a race that crashes RViz: Ogre creates
// RViz's window on one connection to the X server, Mesa asks for its size on another, and the server may
// answer Mesa first. That call then fails, Mesa uses an uninitialised size (such as 168 by 0 pixels), and
// llvmpipe writes past the end of a buffer of 0 bytes. Next to two busy programs one start of RViz in ten
// crashed. The same happens at RViz's end, when the window is destroyed before the last picture.
#include <X11/Xlib.h>
#include <dlfcn.h>

namespace
{
/// Xlib's own function with the name of ours.
template <typename Function>
Function* ofXlib(Function*, const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}
}  // namespace

/// Returns when the window exists on all connections.
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

/// Gives a window that does not exist one pixel, the least possible size.
extern "C" Status XGetGeometry(Display* display, Drawable drawable, Window* root, int* x, int* y,
                               unsigned* width, unsigned* height, unsigned* border_width, unsigned* depth)
{
  static const auto GET = ofXlib(&XGetGeometry, "XGetGeometry");
  const Status found = GET(display, drawable, root, x, y, width, height, border_width, depth);
  if (found == 0)
    *width = *height = 1;
  return found;
}
