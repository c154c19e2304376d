/* The motion that brings points nearest to other points. */
#ifndef DQ8_FIT_HPP
#define DQ8_FIT_HPP

#include "motion.hpp"

namespace dq8 {

/* A motion between points, and how well it fits. `quality.mirrored` is 1 if one of the two arrays has left-handed coordinates. */
template <class T>
struct fitted {
  dq8::motion<T> motion;
  typename detail::abi<T>::fit_quality quality;
};

/* Finds the motion that brings `points` nearest to `moved`, both of three numbers each: the sum of the squared distances, each
   multiplied by its weight, is least. All weights are equal if none are given. If `scaled`, the points are first multiplied by
   the scale that fits best, which is in the quality. Throws an error whose index is the wrong pair. */
template <class Points>
fitted<detail::number<Points>> fit(Points &&points, detail::in<Points> moved, detail::in<Points> weights = {},
                                   bool scaled = false) {
  using T = detail::number<Points>;
  const span<const T> from(points);
  const std::size_t count = detail::things("fit", "points", from.size(), 3);
  detail::length("fit", "moved", moved.size(), from.size()), detail::length_if("fit", "weights", weights.size(), count);
  fitted<T> found{};
  std::size_t bad = nowhere;
  const dq8_status status = detail::abi<T>::fit(from.data(), moved.data(), detail::maybe(weights), count, scaled ? 1 : 0,
                                                found.motion.data(), &found.quality, &bad);
  detail::check("fit", status, bad);
  return found;
}

} // namespace dq8

#endif
