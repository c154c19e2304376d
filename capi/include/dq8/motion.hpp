/* One rigid motion, as eight numbers. */
#ifndef DQ8_MOTION_HPP
#define DQ8_MOTION_HPP

#include "abi.hpp"

namespace dq8 {

/* A motion p + eq: px py pz pw qx qy qz qw. It rotates by p, then translates by t, where q = tp/2. In a product a * b, b acts
   first. An array of motions is an array of their numbers. Operations need unit motions, unless they say otherwise. */
template <class T>
class motion {
  using abi = detail::abi<T>;
  template <class Answer, class Function, class... Arguments>
  static Answer ask(const char *name, Function function, Arguments... arguments) {
    Answer answer{};
    detail::check(name, function(arguments..., first(answer)));
    return answer;
  }
  static T *first(T &number) { return &number; }
  template <class Numbers>
  static T *first(Numbers &numbers) {
    return numbers.data();
  }

 public:
  using vector = std::array<T, 3>;
  using quaternion = std::array<T, 4>; /* x y z w */
  using twist = std::array<T, 6>;      /* angular x y z, then linear x y z */
  using line = std::array<T, 6>;       /* direction x y z, then moment x y z */
  using plane = std::array<T, 4>;      /* normal x y z, then offset */
  using screw = std::array<T, 8>;

  /* The identity, which moves nothing. */
  motion() = default;
  static motion identity() { return ask<motion>("motion::identity", abi::motion_identity); }
  explicit motion(const std::array<T, 8> &numbers) : numbers_(numbers) {}
  /* Rotates by a unit quaternion (x, y, z, w), then moves by a translation. */
  motion(const quaternion &rotation, const vector &translation)
      : motion(ask<motion>("motion", abi::motion_from_rotation_translation, rotation.data(), translation.data())) {}
  /* Moves by a translation. */
  static motion translation_by(const vector &translation) { return motion({0, 0, 0, 1}, translation); }
  /* Rotates by a unit quaternion (x, y, z, w). */
  static motion rotation_by(const quaternion &rotation) { return motion(rotation, {0, 0, 0}); }
  /* Takes a matrix of 12 or 16 numbers, row by row. The dot products of the rows of its rotation may differ from 0 and 1 by
     `tolerance`. */
  static motion from_matrix(span<const T> matrix, T tolerance = T(1e-5)) {
    if (matrix.size() == 16) return ask<motion>("motion::from_matrix", abi::motion_from_matrix_4x4, matrix.data(), tolerance);
    if (matrix.size() != 12) detail::refuse("motion::from_matrix", "matrix", matrix.size(), "12 or 16 numbers");
    return ask<motion>("motion::from_matrix", abi::motion_from_matrix_3x4, matrix.data(), tolerance);
  }
  static motion from_screw(const screw &numbers) {
    return ask<motion>("motion::from_screw", abi::motion_from_screw, numbers.data());
  }
  /* Makes the rotation of three turns about coordinate axes, in radians, the first turn first. `order` has three letters, none
     twice in a row: small ones such as "xyz" are axes that stay fixed, and capitals such as "ZYX" turn with the body. */
  static motion from_euler(const char *order, const vector &angles) {
    return ask<motion>("motion::from_euler", abi::motion_from_euler, order, angles.data());
  }
  static motion exp(const twist &log) { return ask<motion>("motion::exp", abi::motion_exp, log.data()); }
  /* Blends motions by weights, which need not sum to 1, and normalizes. */
  static motion blend(span<const T> motions, span<const T> weights) {
    const std::size_t count = detail::things("motion::blend", "motions", motions.size(), 8);
    detail::length("motion::blend", "weights", weights.size(), count);
    return ask<motion>("motion::blend", abi::motion_blend, motions.data(), weights.data(), count);
  }
  /* Computes the intrinsic mean of motions, with equal weights if none are given. Returns it, and true if `most` steps found
     it. */
  static std::pair<motion, bool> mean(span<const T> motions, span<const T> weights = {}, std::uint32_t most = 32) {
    const std::size_t count = detail::things("motion::mean", "motions", motions.size(), 8);
    detail::length_if("motion::mean", "weights", weights.size(), count);
    const T tolerance = std::is_same_v<T, float> ? T(1e-6) : T(1e-14);
    std::pair<motion, bool> mean;
    std::int32_t converged = 0;
    detail::check("motion::mean", abi::motion_mean(motions.data(), detail::maybe(weights), count, tolerance, most,
                                                   mean.first.data(), &converged));
    mean.second = converged == 1;
    return mean;
  }

  T *data() { return numbers_.data(); }
  const T *data() const { return numbers_.data(); }
  static constexpr std::size_t size() { return 8; }
  T &operator[](std::size_t index) { return numbers_[index]; }
  const T &operator[](std::size_t index) const { return numbers_[index]; }

  friend motion operator*(const motion &a, const motion &b) { return ask<motion>("motion * motion", abi::motion_mul, a.data(), b.data()); }
  motion &operator*=(const motion &other) { return *this = *this * other; }
  friend bool operator==(const motion &a, const motion &b) { return a.numbers_ == b.numbers_; }
  friend bool operator!=(const motion &a, const motion &b) { return !(a == b); }

  /* The unit quaternion (x, y, z, w) of the rotation. */
  quaternion rotation() const { return parts().first; }
  vector translation() const { return parts().second; }
  /* The angles of `from_euler` in radians, the angle of the first turn first. The middle one is from -pi/2 to pi/2 if the three
     axes differ, and otherwise from 0 to pi. If the first and the last axis coincide, the last angle is 0. */
  vector to_euler(const char *order) const {
    vector angles{};
    detail::check("motion::to_euler", abi::motion_to_euler(data(), order, angles.data(), nullptr));
    return angles;
  }
  std::array<T, 12> to_matrix_3x4() const { return ask<std::array<T, 12>>("motion::to_matrix_3x4", abi::motion_to_matrix_3x4, data()); }
  std::array<T, 16> to_matrix_4x4() const { return ask<std::array<T, 16>>("motion::to_matrix_4x4", abi::motion_to_matrix_4x4, data()); }
  screw to_screw() const { return ask<screw>("motion::to_screw", abi::motion_to_screw, data()); }
  /* The twist, applied for one second, that makes the motion. */
  twist to_twist() const { return ask<twist>("motion::to_twist", abi::motion_to_twist, data()); }
  /* The logarithm of the dual quaternion: half of the twist. */
  twist log() const { return ask<twist>("motion::log", abi::motion_log, data()); }
  motion pow(T t) const { return ask<motion>("motion::pow", abi::motion_pow, data(), t); }

  motion conjugate() const { return ask<motion>("motion::conjugate", abi::motion_conjugate, data()); }
  /* The inverse; the motion need not be unit. */
  motion inverse() const { return ask<motion>("motion::inverse", abi::motion_inverse, data()); }
  /* The nearest unit motion; the motion need not be unit. */
  motion normalized() const { return ask<motion>("motion::normalized", abi::motion_normalize, data()); }
  /* Whether the norm differs from 1 by at most `tolerance`. */
  bool is_unit(T tolerance = T(1e-5)) const { return abi::motion_check_unit(data(), tolerance) == DQ8_STATUS_OK; }

  vector point(const vector &point) const { return ask<vector>("motion::point", abi::motion_point, data(), point.data()); }
  /* Turns a direction, which is not translated. */
  vector direction(const vector &v) const { return ask<vector>("motion::direction", abi::motion_vector, data(), v.data()); }
  line move_line(const line &of) const { return ask<line>("motion::move_line", abi::motion_line, data(), of.data()); }
  plane move_plane(const plane &of) const { return ask<plane>("motion::move_plane", abi::motion_plane, data(), of.data()); }
  /* Applies the adjoint of the motion to a twist. */
  twist adjoint(const twist &of) const { return ask<twist>("motion::adjoint", abi::motion_twist, data(), of.data()); }
  /* Moves on by `dt` seconds of a body twist. */
  motion integrate_body(const twist &body, T dt) const {
    return ask<motion>("motion::integrate_body", abi::motion_integrate_body, data(), body.data(), dt);
  }

  /* Interpolates to `end` (t = 1) along one screw. */
  motion sclerp(const motion &end, T t) const { return ask<motion>("motion::sclerp", abi::motion_sclerp, data(), end.data(), t); }
  /* Interpolates by a linear blend, which is quicker, and nearly at constant speed. */
  motion nlerp(const motion &end, T t) const { return ask<motion>("motion::nlerp", abi::motion_nlerp, data(), end.data(), t); }
  T angle_to(const motion &other) const { return ask<T>("motion::angle_to", abi::motion_angle_to, data(), other.data()); }
  T distance_to(const motion &other) const { return ask<T>("motion::distance_to", abi::motion_distance_to, data(), other.data()); }

 private:
  std::pair<quaternion, vector> parts() const {
    std::pair<quaternion, vector> parts;
    detail::check("motion", abi::motion_to_rotation_translation(data(), parts.first.data(), parts.second.data()));
    return parts;
  }

  std::array<T, 8> numbers_{0, 0, 0, 1};
};

template <class T>
struct record<motion<T>> : record<T[8]> {};

} // namespace dq8

#endif
