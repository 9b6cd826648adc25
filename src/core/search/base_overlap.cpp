#include "search/base_overlap.h"

#include <cstddef>

namespace ratchet_sieve
{

BaseOverlap::BaseOverlap(const BaseShape& shape)
    : shape_(shape),
      height_(shape.height()),
      wall_(shape.boundary() == Boundary::WALLED),
      periodic_(shape.boundary() == Boundary::PERIODIC),
      even_(std::all_of(shape.corners().begin(), shape.corners().end(),
                        [&](const auto& corner) { return corner.position.y() == shape.height(); })),
      width_(shape.width()),
      tooth_width_(shape.toothWidth()),
      teeth_per_length_(1.0 / tooth_width_),
      first_corner_(shape.corners().empty() ? 0.0 : shape.corners().front().position.x())
{
  const auto& faces = shape.faces();
  const std::size_t first =
      shape.corners().empty() ? 0 : static_cast<std::size_t>(shape.corners().front().number);
  auto corner = shape.corners().begin();
  lines_.reserve(faces.size());
  for (std::size_t k = 0; k < faces.size(); ++k)
  {
    // Up to the end of the tooth before, and then on from the start of the tooth.
    const BaseShape::Face& face = faces[(first + k) % faces.size()];
    const double shift = first + k < faces.size() ? tooth_width_ : 0.0;
    const bool at_corner = corner != shape.corners().end() && corner->number == face.number;
    if (k == 0 || at_corner)
      pockets_.push_back({(at_corner ? corner->position.x() : 0.0) - shift, lines_.data() + k, nullptr});
    if (at_corner)
      ++corner;
    lines_.push_back({face.normal, (face.foot - Eigen::Vector2d(shift, 0.0)).dot(face.normal)});
    pockets_.back().end = lines_.data() + k + 1;
  }
  is_valley_ = even_ && pockets_.size() == 1 && lines_.size() == 2 && lines_.front().offset == 0.0 &&
               lines_.back().offset == 0.0;
}

std::optional<double> BaseOverlap::wayOut(double s, double n, double radius) const
{
  if (n >= height_ || (!periodic_ && beyondEnds(s, 0.0)))
    return std::nullopt;
  const double local = inPockets(s);
  const double over_all = height_ + radius - n;
  double nearest = over_all;
  double over_faces = 0.0;
  const Pocket& pocket = pocketAt(local);
  for (const Line* line = pocket.begin; line != pocket.end; ++line)
  {
    const double distance = line->distance(local, n);
    nearest = std::min(nearest, distance);
    over_faces =
        std::max(over_faces, line->normal.y() > 0.0 ? (radius - distance) / line->normal.y() : over_all);
  }
  if (nearest >= 0.0)
    return std::nullopt;
  return std::min(over_all, over_faces);
}

}  // namespace ratchet_sieve
