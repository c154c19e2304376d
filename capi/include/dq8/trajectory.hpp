/* Poses over time: at stamps, or on a spline. */
#ifndef DQ8_TRAJECTORY_HPP
#define DQ8_TRAJECTORY_HPP

#include "motion.hpp"

namespace dq8 {

/* The clock of the times, the poses outside of the stamps, and the frame of the results. Without options, times are in seconds,
   results are in the world, and the body stands before the first stamp and after the last one. */
struct trajectory_options : dq8_trajectory_options {
  trajectory_options() : dq8_trajectory_options{0, 1, 0, 0, 0, {0, 0, 0, 1, 0, 0, 0, 0}} {}
  /* A time t is at the stamp origin + unit * t, in seconds. */
  trajectory_options &clock(double at, double seconds) { return origin = at, unit = seconds, *this; }
  /* Outside of the stamps, the body goes on as it moves between the nearest two. */
  trajectory_options &continues() { return outside = 1, *this; }
  /* Times outside of the stamps are errors. */
  trajectory_options &refuses() { return outside = 2, *this; }
  /* Results are in the frame of the body at the first stamp, at the last stamp, or at a time in seconds on its clock. */
  trajectory_options &in_start() { return frame = 1, *this; }
  trajectory_options &in_end() { return frame = 2, *this; }
  trajectory_options &in_body_at(double seconds) { return frame = 3, time = seconds, *this; }
  /* Results are in a frame whose pose in the world is given. */
  trajectory_options &in_pose(const motion<double> &of) {
    frame = 4;
    for (std::size_t i = 0; i < of.size(); i++) pose[i] = of[i];
    return *this;
  }
};

/* Poses at rising stamps, in seconds, between which a body moves along one screw. It owns its memory. Times may be in any
   order; results are float or double. A trajectory that has been moved away throws. */
class trajectory {
 public:
  /* Throws an error whose index is the wrong stamp. */
  trajectory(span<const double> stamps, span<const double> poses)
      : stamps_(stamps.begin(), stamps.end()), poses_(poses.begin(), poses.end()) {
    detail::length("trajectory", "poses", poses.size(), 8 * stamps.size());
    double *none = nullptr;
    call("trajectory", detail::abi<double>::trajectory_sample, {}, {}, none, none);
  }

  /* Computes the pose at each time, and the body twist there: angular x y z, then linear x y z, per second. */
  template <class Out>
  void sample(span<const double> times, Out &&poses, span<detail::number<Out>> twists = {},
              const trajectory_options &options = {}) const {
    constexpr auto name = "trajectory::sample";
    const span<detail::number<Out>> to(poses);
    detail::length(name, "poses", to.size(), 8 * times.size());
    detail::length_if(name, "twists", twists.size(), 6 * times.size());
    call(name, detail::abi<detail::number<Out>>::trajectory_sample, options, times, to.data(), detail::maybe(twists));
  }
  /* Moves points that the body has measured, each by the pose at its own time, into one frame. `moved` may be `points`. */
  template <class Out>
  void deskew(span<const double> times, detail::in<Out> points, Out &&moved, const trajectory_options &options = {}) const {
    move("trajectory::deskew", detail::abi<detail::number<Out>>::trajectory_deskew, options, times, points,
         span<detail::number<Out>>(moved));
  }
  /* The inverse of deskew. */
  template <class Out>
  void skew(span<const double> times, detail::in<Out> points, Out &&moved, const trajectory_options &options = {}) const {
    move("trajectory::skew", detail::abi<detail::number<Out>>::trajectory_skew, options, times, points,
         span<detail::number<Out>>(moved));
  }

 private:
  template <class Function, class T>
  void move(const char *name, Function function, const trajectory_options &options, span<const double> times,
            span<const T> points, span<T> moved) const {
    detail::length(name, "points", points.size(), 3 * times.size());
    detail::length(name, "the output", moved.size(), 3 * times.size());
    call(name, function, options, times, points.data(), moved.data());
  }
  template <class Function, class... Arrays>
  void call(const char *name, Function function, const trajectory_options &options, span<const double> times,
            Arrays... arrays) const {
    owner_.check("trajectory");
    std::size_t bad = nowhere;
    const dq8_status status =
        function(stamps_.data(), poses_.data(), stamps_.size(), &options, times.data(), arrays..., times.size(), &bad);
    detail::check(name, status, bad);
  }

  std::vector<double> stamps_, poses_;
  detail::owner owner_;
};

/* A cubic spline by control poses, of which pose k belongs to the time start + every * (k - 1), in seconds. */
class spline {
 public:
  /* A smooth spline passes near its control poses; one that passes through them does so but for the first and the last. */
  enum class basis : std::int32_t { smooth = 0, through = 1 };

  /* Throws an error whose index is the wrong control pose. */
  spline(double start, double every, span<const double> control, basis kind = basis::smooth)
      : control_(control.begin(), control.end()), start_(start), every_(every), basis_(kind) {
    detail::things("spline", "control", control.size(), 8);
    double *none = nullptr;
    call<double>("spline", {}, {}, none, none, none);
  }
  /* Computes the pose at each time, the body twist there, and the derivative of the twist by time. */
  template <class Out>
  void sample(span<const double> times, Out &&poses, span<detail::number<Out>> twists = {},
              span<detail::number<Out>> accelerations = {}, const trajectory_options &options = {}) const {
    constexpr auto name = "spline::sample";
    const span<detail::number<Out>> to(poses);
    detail::length(name, "poses", to.size(), 8 * times.size());
    detail::length_if(name, "twists", twists.size(), 6 * times.size());
    detail::length_if(name, "accelerations", accelerations.size(), 6 * times.size());
    call<detail::number<Out>>(name, times, options, to.data(), detail::maybe(twists), detail::maybe(accelerations));
  }

 private:
  template <class T>
  void call(const char *name, span<const double> times, const trajectory_options &options, T *poses, T *twists,
            T *accelerations) const {
    owner_.check("spline");
    std::size_t bad = nowhere;
    const dq8_status status = detail::abi<T>::spline_poses(
        control_.data(), control_.size() / 8, start_, every_, static_cast<std::int32_t>(basis_), &options, times.data(),
        poses, twists, accelerations, times.size(), &bad);
    detail::check(name, status, bad);
  }

  std::vector<double> control_;
  double start_, every_;
  basis basis_;
  detail::owner owner_;
};

/* Samples poses at rising times at other times. */
template <class Out>
void resample(detail::in<Out> times, detail::in<Out> poses, detail::in<Out> at, Out &&out) {
  const span<detail::number<Out>> to(out);
  detail::length("resample", "poses", poses.size(), 8 * times.size());
  detail::length("resample", "out", to.size(), 8 * at.size());
  std::size_t bad = nowhere;
  const dq8_status status = detail::abi<detail::number<Out>>::resample(times.data(), poses.data(), times.size(), at.data(),
                                                                       to.data(), at.size(), &bad);
  detail::check("resample", status, bad);
}

} // namespace dq8

#endif
