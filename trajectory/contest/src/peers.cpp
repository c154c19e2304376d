// The loops that dq8-trajectory is compared with, as users write them with Eigen. Sophus is not in Debian 12: its exponential,
// logarithm and products are written from their formulas. Arrays have the sizes that build.rs gives.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

template <class R> using Vector = Eigen::Matrix<R, 3, 1>;
template <class R> using Matrix = Eigen::Matrix<R, 3, 3>;
template <class R> using Six = Eigen::Matrix<R, 6, 1>;  // angular first

template <class R> Matrix<R> hat(const Vector<R>& v) {
  Matrix<R> m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// Sophus' SE3: a unit quaternion, which products and inverses make unit again, and a translation.
template <class R> struct Pose {
  Eigen::Quaternion<R> rotation;
  Vector<R> translation;

  Pose operator*(const Pose& other) const {
    return {(rotation * other.rotation).normalized(), translation + rotation * other.translation};
  }
  Vector<R> operator*(const Vector<R>& point) const { return rotation * point + translation; }
  Pose inverse() const {
    const Eigen::Quaternion<R> back = rotation.conjugate().normalized();
    return {back, -(back * translation)};
  }
  Eigen::Matrix<R, 6, 6> adjoint() const {
    const Matrix<R> turn = rotation.toRotationMatrix();
    Eigen::Matrix<R, 6, 6> m;
    m << turn, Matrix<R>::Zero(), hat(translation) * turn, turn;
    return m;
  }
};

template <class R> constexpr R TINY = std::numeric_limits<R>::epsilon() * std::numeric_limits<R>::epsilon();

template <class R> Pose<R> exp(const Six<R>& twist) {
  const Vector<R> omega = twist.template head<3>();
  const Matrix<R> turn = hat(omega);
  const R square = omega.squaredNorm();
  R imaginary = R(0.5), real = 1;
  Matrix<R> left = Matrix<R>::Identity() + R(0.5) * turn;
  if (square > TINY<R>) {
    const R theta = std::sqrt(square);
    imaginary = std::sin(theta / 2) / theta;
    real = std::cos(theta / 2);
    left = Matrix<R>::Identity() + (1 - std::cos(theta)) / square * turn +
           (theta - std::sin(theta)) / (square * theta) * (turn * turn);
  }
  const Vector<R> part = imaginary * omega;
  return {{real, part.x(), part.y(), part.z()}, left * twist.template tail<3>()};
}

template <class R> Six<R> log(const Pose<R>& pose) {
  const R sign = pose.rotation.w() < 0 ? -1 : 1;
  const R w = sign * pose.rotation.w(), square = pose.rotation.vec().squaredNorm();
  R factor = 2 / w, third = R(1) / 12;
  if (square > TINY<R>) {
    const R norm = std::sqrt(square), theta = 4 * std::atan(norm / (w + 1));
    factor = theta / norm;
    third = (1 - theta * std::cos(theta / 2) / (2 * std::sin(theta / 2))) / (theta * theta);
  }
  const Vector<R> omega = factor * sign * pose.rotation.vec();
  const Matrix<R> turn = hat(omega);
  const Matrix<R> inverse = Matrix<R>::Identity() - R(0.5) * turn + third * (turn * turn);
  Six<R> twist;
  twist << omega, inverse * pose.translation;
  return twist;
}

// The numbers there, to be read or written.
template <class R, int N> Eigen::Map<const Eigen::Matrix<R, N, 1>> get(const R (&numbers)[N]) {
  return Eigen::Map<const Eigen::Matrix<R, N, 1>>(numbers);
}
template <class R, class V> void put(R* numbers, const V& vector) {
  Eigen::Map<Eigen::Matrix<R, V::RowsAtCompileTime, 1>> there(numbers);
  there = vector;
}

// A quaternion x, y, z, w and a translation.
template <class R> Pose<R> pose(const double (&v)[7]) {
  return {Eigen::Quaternion<R>(v[3], v[0], v[1], v[2]), Vector<R>(v[4], v[5], v[6])};
}

// The index of the segment that a time lies in: the next one for times that rise, else searched for.
template <class R> struct Finder {
  const std::vector<R> stamps;
  const bool rises;
  size_t near = 0;

  size_t operator()(R time) {
    if (rises) {
      while (near + 2 < stamps.size() && stamps[near + 1] <= time) ++near;
      return near;
    }
    const auto after = std::upper_bound(stamps.begin() + 1, stamps.end() - 1, time);
    return after - stamps.begin() - 1;
  }
};

// Each point by slerp of the rotations and lerp of the translations around its time.
template <class R>
void slerp_lerp(const double (&stamps)[POSES], const double (&poses)[POSES][7], bool rises, const R (&times)[POINTS],
                const R (&points)[POINTS][3], R (&moved)[POINTS][3]) {
  std::vector<Pose<R>> path;
  for (const auto& numbers : poses) path.push_back(pose<R>(numbers));
  Finder<R> find{{stamps, stamps + POSES}, rises};
  for (size_t i = 0; i < POINTS; ++i) {
    const size_t k = find(times[i]);
    const auto &a = path[k], &b = path[k + 1];
    const R share = (times[i] - find.stamps[k]) / (find.stamps[k + 1] - find.stamps[k]);
    const Vector<R> shift = (1 - share) * a.translation + share * b.translation;
    put(moved[i], a.rotation.slerp(share, b.rotation) * get(points[i]) + shift);
  }
}

// Each point by the screw motion around its time, whose logarithms are kept.
template <class R>
void screws(const double (&stamps)[POSES], const double (&poses)[POSES][7], bool rises, const R (&times)[POINTS],
            const R (&points)[POINTS][3], R (&moved)[POINTS][3]) {
  std::vector<Pose<R>> path;
  for (const auto& numbers : poses) path.push_back(pose<R>(numbers));
  std::vector<Six<R>> ways;
  for (size_t k = 0; k + 1 < POSES; ++k) ways.push_back(log(path[k].inverse() * path[k + 1]));
  Finder<R> find{{stamps, stamps + POSES}, rises};
  for (size_t i = 0; i < POINTS; ++i) {
    const size_t k = find(times[i]);
    const R share = (times[i] - find.stamps[k]) / (find.stamps[k + 1] - find.stamps[k]);
    put(moved[i], (path[k] * exp<R>(share * ways[k])) * get(points[i]));
  }
}

// KISS-ICP: the motion of the scan is one twist, times go from 0 to 1, and points come into the frame of its end.
template <class R>
void constant_twist(const double (&twist)[6], const R (&times)[POINTS], const R (&points)[POINTS][3], R (&moved)[POINTS][3]) {
  const Six<R> omega = get(twist).template cast<R>();
  for (size_t i = 0; i < POINTS; ++i) {
    put(moved[i], exp<R>((times[i] - 1) * omega) * get(points[i]));
  }
}

// The cumulative cubic B-spline with its body twist, knots a second apart, as basalt's helper computes it: weights by a matrix, then
// factor after factor. If `keeps`, the logarithms are taken once and not at every time.
template <class R>
void spline(const double (&control)[CONTROL][7], bool keeps, const R (&times)[POINTS], R (&poses)[POINTS][7],
            R (&twists)[POINTS][6]) {
  std::vector<Pose<R>> path;
  for (const auto& numbers : control) path.push_back(pose<R>(numbers));
  std::vector<Six<R>> ways;
  for (size_t k = 0; keeps && k + 1 < CONTROL; ++k) ways.push_back(log(path[k].inverse() * path[k + 1]));
  Eigen::Matrix<R, 4, 4> blend;
  blend << 6, 0, 0, 0, 5, 3, -3, 1, 1, 3, 3, -2, 0, 0, 0, 1;
  blend /= 6;
  for (size_t i = 0; i < POINTS; ++i) {
    const size_t k = std::min(size_t(times[i]), size_t(CONTROL - 4));
    const R u = times[i] - k;
    const Eigen::Matrix<R, 4, 1> value = blend * Eigen::Matrix<R, 4, 1>(1, u, u * u, u * u * u);
    const Eigen::Matrix<R, 4, 1> speed = blend * Eigen::Matrix<R, 4, 1>(0, 1, 2 * u, 3 * u * u);
    Pose<R> at = path[k];
    Six<R> twist = Six<R>::Zero();
    for (size_t j = 1; j < 4; ++j) {
      const Six<R> way = keeps ? ways[k + j - 1] : log(path[k + j - 1].inverse() * path[k + j]);
      const Pose<R> step = exp<R>(value[j] * way);
      at = at * step;
      twist = step.inverse().adjoint() * twist + speed[j] * way;
    }
    put(poses[i], at.rotation.coeffs());
    put(poses[i] + 4, at.translation);
    put(twists[i], twist);
  }
}

}  // namespace

#define BOTH(R)                                                                                                              \
  extern "C" void slerp_lerp_##R(const double (&stamps)[POSES], const double (&poses)[POSES][7], bool rises,                  \
                                 const R (&times)[POINTS], const R (&points)[POINTS][3], R (&moved)[POINTS][3]) {             \
    slerp_lerp(stamps, poses, rises, times, points, moved);                                                                  \
  }                                                                                                                          \
  extern "C" void screws_##R(const double (&stamps)[POSES], const double (&poses)[POSES][7], bool rises,                      \
                             const R (&times)[POINTS], const R (&points)[POINTS][3], R (&moved)[POINTS][3]) {                 \
    screws(stamps, poses, rises, times, points, moved);                                                                      \
  }                                                                                                                          \
  extern "C" void constant_twist_##R(const double (&twist)[6], const R (&times)[POINTS], const R (&points)[POINTS][3],        \
                                     R (&moved)[POINTS][3]) {                                                                \
    constant_twist(twist, times, points, moved);                                                                             \
  }                                                                                                                          \
  extern "C" void spline_##R(const double (&control)[CONTROL][7], bool keeps, const R (&times)[POINTS],                       \
                             R (&poses)[POINTS][7], R (&twists)[POINTS][6]) {                                                 \
    spline(control, keeps, times, poses, twists);                                                                            \
  }
BOTH(float)
BOTH(double)
