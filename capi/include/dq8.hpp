/*
 * dq8 for C++17. An array is anything with data() and size(): a vector, an array, std::span, dq8::span. The output decides
 * between float and double. Lengths are checked here, and every error of dq8.h is thrown. Classes own the memory that dq8.h
 * leaves to you. dq8.h has the formulas and conventions.
 */
#ifndef DQ8_HPP
#define DQ8_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "dq8.h"

namespace dq8 {

/* A status that is not DQ8_STATUS_OK. `index` is the wrong joint, vertex or time, if the function tells. */
struct error : std::runtime_error {
  dq8_status status;
  std::size_t index;
  explicit error(dq8_status status, std::size_t index = SIZE_MAX)
      : std::runtime_error(dq8_status_text(status)), status(status), index(index) {}
};

/* A view of numbers that something else owns, for compilers without std::span. */
template <class T>
class span {
 public:
  span() = default;
  span(T *data, std::size_t size) : data_(data), size_(size) {}
  template <class Range, class = std::enable_if_t<std::is_convertible_v<decltype(std::data(std::declval<Range &>())), T *>>>
  span(Range &&range) : data_(std::data(range)), size_(std::size(range)) {}
  T *data() const { return data_; }
  std::size_t size() const { return size_; }
  T *begin() const { return data_; }
  T *end() const { return data_ + size_; }
  T &operator[](std::size_t index) const { return data_[index]; }

 private:
  T *data_ = nullptr;
  std::size_t size_ = 0;
};

/* A motion: px py pz pw qx qy qz qw. */
template <class T>
using motion = std::array<T, 8>;

namespace detail {

inline void check(dq8_status status, std::size_t index = SIZE_MAX) {
  if (status != DQ8_STATUS_OK) throw error(status, index);
}
/* The number of things of `each` numbers. Throws if the last one is incomplete. */
inline std::size_t things(std::size_t size, std::size_t each) {
  if (size % each != 0) throw error(DQ8_STATUS_LENGTH);
  return size / each;
}
inline void same(std::size_t size, std::size_t as) {
  if (size != as) throw error(DQ8_STATUS_LENGTH);
}

template <class Range>
using number = std::remove_reference_t<decltype(*std::data(std::declval<Range &>()))>;

/* The functions of dq8.h for a number type. */
template <class T>
struct abi;

#define DQ8_ABI(number, suffix)                                                \
  template <>                                                                  \
  struct abi<number> {                                                         \
    using joint = dq8_joint_##suffix;                                          \
    using step = dq8_step_##suffix;                                            \
    using mechanism = dq8_mechanism_##suffix;                                  \
    using skin = dq8_skin_##suffix;                                            \
    using goal = dq8_goal_##suffix;                                            \
    using reach_options = dq8_reach_options_##suffix;                          \
    using reach_report = dq8_reach_report_##suffix;                            \
    static constexpr auto mul = &dq8_mul_##suffix;                             \
    static constexpr auto normalize = &dq8_normalize_##suffix;                 \
    static constexpr auto inverse = &dq8_inverse_##suffix;                     \
    static constexpr auto sclerp = &dq8_sclerp_##suffix;                       \
    static constexpr auto nlerp = &dq8_nlerp_##suffix;                         \
    static constexpr auto points = &dq8_points_##suffix;                       \
    static constexpr auto points_each = &dq8_points_each_##suffix;             \
    static constexpr auto matrices_3x4 = &dq8_matrices_3x4_##suffix;           \
    static constexpr auto resample = &dq8_resample_##suffix;                   \
    static constexpr auto local_to_model = &dq8_local_to_model_##suffix;       \
    static constexpr auto palette = &dq8_palette_##suffix;                     \
    static constexpr auto mechanism_make = &dq8_mechanism_make_##suffix;       \
    static constexpr auto link_poses = &dq8_link_poses_##suffix;               \
    static constexpr auto link_pose = &dq8_mechanism_link_pose_##suffix;       \
    static constexpr auto jacobian = &dq8_mechanism_link_jacobian_##suffix;    \
    static constexpr auto reach_scratch = &dq8_reach_scratch_##suffix;         \
    static constexpr auto reach = &dq8_reach_##suffix;                         \
    static constexpr auto mean = &dq8_motion_mean_##suffix;                    \
    static constexpr auto skin_make = &dq8_skin_make_##suffix;                 \
    static constexpr auto skin_dual = &dq8_skin_dual_##suffix;                 \
    static constexpr auto skin_linear = &dq8_skin_linear_##suffix;             \
  };
DQ8_ABI(float, f32)
DQ8_ABI(double, f64)
#undef DQ8_ABI

/* Calls a function from an array of motions to as many. */
template <class Function, class Motions, class Out>
void from_one(Function function, const Motions &motions, Out &out) {
  using T = number<Out>;
  const span<const T> from(motions);
  const span<T> to(out);
  same(from.size(), to.size());
  check(function(from.data(), to.data(), things(to.size(), 8)));
}
/* Calls a function from pairs of motions, and perhaps a number, to as many. */
template <class Function, class A, class B, class Out, class... More>
void from_two(Function function, const A &a, const B &b, Out &out, More... more) {
  using T = number<Out>;
  const span<const T> first(a), second(b);
  const span<T> to(out);
  same(first.size(), to.size()), same(second.size(), to.size());
  check(function(first.data(), second.data(), more..., to.data(), things(to.size(), 8)));
}

} // namespace detail

/* out[i] = a[i] * b[i]. */
template <class A, class B, class Out>
void mul(const A &a, const B &b, Out &&out) {
  detail::from_two(detail::abi<detail::number<Out>>::mul, a, b, out);
}

/* out[i] = motions[i], normalized. `out` may be `motions`. */
template <class Motions, class Out>
void normalize(const Motions &motions, Out &&out) {
  detail::from_one(detail::abi<detail::number<Out>>::normalize, motions, out);
}

/* out[i] = the inverse of motions[i]. `out` may be `motions`. */
template <class Motions, class Out>
void inverse(const Motions &motions, Out &&out) {
  detail::from_one(detail::abi<detail::number<Out>>::inverse, motions, out);
}

/* Interpolates from a[i] (t = 0) to b[i] (t = 1) along one screw. */
template <class A, class B, class Out>
void sclerp(const A &a, const B &b, detail::number<Out> t, Out &&out) {
  detail::from_two(detail::abi<detail::number<Out>>::sclerp, a, b, out, t);
}

/* Interpolates by linear blends, which is quicker, and nearly at constant speed. */
template <class A, class B, class Out>
void nlerp(const A &a, const B &b, detail::number<Out> t, Out &&out) {
  detail::from_two(detail::abi<detail::number<Out>>::nlerp, a, b, out, t);
}

/* Moves points by one motion, or each by its own if there are as many. `out` may be `points`. */
template <class Motions, class Points, class Out>
void points(const Motions &motions, const Points &points, Out &&out) {
  using T = detail::number<Out>;
  const span<const T> by(motions), from(points);
  const span<T> to(out);
  const std::size_t count = detail::things(to.size(), 3);
  detail::same(from.size(), to.size());
  if (by.size() == 8) {
    detail::check(detail::abi<T>::points(by.data(), from.data(), to.data(), count));
  } else {
    detail::same(by.size(), 8 * count);
    detail::check(detail::abi<T>::points_each(by.data(), from.data(), to.data(), count));
  }
}

/* Writes the matrices [R | t] of unit motions, row by row. */
template <class Motions, class Out>
void matrices_3x4(const Motions &motions, Out &&out) {
  using T = detail::number<Out>;
  const span<const T> from(motions);
  const span<T> to(out);
  const std::size_t count = detail::things(to.size(), 12);
  detail::same(from.size(), 8 * count);
  detail::check(detail::abi<T>::matrices_3x4(from.data(), DQ8_MATRIX_ORDER_ROWS, to.data(), count));
}

/* Samples poses at rising times at other times. */
template <class Times, class Poses, class At, class Out>
void resample(const Times &times, const Poses &poses, const At &at, Out &&out) {
  using T = detail::number<Out>;
  const span<const T> known(times), from(poses), when(at);
  const span<T> to(out);
  detail::same(from.size(), 8 * known.size()), detail::same(to.size(), 8 * when.size());
  std::size_t bad = SIZE_MAX;
  const dq8_status status =
      detail::abi<T>::resample(known.data(), from.data(), known.size(), when.data(), to.data(), when.size(), &bad);
  detail::check(status, bad);
}

/* Computes the intrinsic mean of motions, with equal weights if none are given. Returns it, and true if `most` steps found it. */
template <class Motions>
auto mean(const Motions &motions, span<const std::remove_const_t<detail::number<Motions>>> weights = {},
          std::uint32_t most = 32) {
  using T = std::remove_const_t<detail::number<Motions>>;
  const span<const T> from(motions);
  const std::size_t count = detail::things(from.size(), 8);
  if (weights.size() != 0) detail::same(weights.size(), count);
  motion<T> mean{};
  std::int32_t converged = 0;
  const T tolerance = std::is_same_v<T, float> ? T(1e-6) : T(1e-14);
  detail::check(detail::abi<T>::mean(from.data(), weights.data(), count, tolerance, most, mean.data(), &converged));
  return std::pair(mean, converged == 1);
}

/* Computes the model poses of one or many skeletons from local poses. `models` may be `locals`. */
template <class Locals, class Models>
void local_to_model(span<const std::int32_t> parents, const Locals &locals, Models &&models) {
  using T = detail::number<Models>;
  const span<const T> from(locals);
  const span<T> to(models);
  detail::same(from.size(), to.size());
  detail::check(detail::abi<T>::local_to_model(parents.data(), parents.size(), nullptr, from.data(), to.data(),
                                               detail::things(to.size(), 8)));
}

/* Computes model poses, and palette[i] = models[i] * inverse_binds[joint]. */
template <class Locals, class Binds, class Models, class Palette>
void palette(span<const std::int32_t> parents, const Locals &locals, const Binds &inverse_binds, Models &&models,
             Palette &&palette) {
  using T = detail::number<Models>;
  const span<const T> from(locals), binds(inverse_binds);
  const span<T> to(models), also(palette);
  detail::same(from.size(), to.size()), detail::same(also.size(), to.size()), detail::same(binds.size(), 8 * parents.size());
  detail::check(detail::abi<T>::palette(parents.data(), parents.size(), nullptr, from.data(), binds.data(), to.data(),
                                        also.data(), detail::things(to.size(), 8)));
}

/* A robot of joints that have been checked once. It owns its memory, and can be moved but not copied. */
template <class T>
class mechanism {
  using abi = detail::abi<T>;

 public:
  using joint = typename abi::joint;

  /* Throws an error whose index is the wrong joint. */
  explicit mechanism(span<const joint> joints) : steps_(joints.size()) {
    std::size_t bad = SIZE_MAX;
    const dq8_status status = abi::mechanism_make(joints.data(), joints.size(), steps_.data(), &made_, &bad);
    detail::check(status, bad);
  }
  mechanism(mechanism &&) = default;
  mechanism &operator=(mechanism &&) = default;

  std::size_t links() const { return made_.links; }
  std::size_t values() const { return made_.values; }
  std::size_t rates() const { return made_.rates; }

  /* Computes the poses of all links of one or many configurations: [configuration][link] from [configuration][value]. */
  void poses(span<const T> values, span<T> poses) const {
    detail::check(abi::link_poses(&made_, values.data(), values.size(), poses.data(), detail::things(poses.size(), 8)));
  }
  motion<T> pose(span<const T> values, std::size_t link) const {
    motion<T> pose;
    detail::check(abi::link_pose(&made_, values.data(), values.size(), link, pose.data()));
    return pose;
  }
  /* Computes the Jacobian of a link, a column of six numbers for each rate, and the pose of the link. */
  motion<T> jacobian(span<const T> values, std::size_t link, span<T> columns,
                     std::int32_t frame = DQ8_FRAME_WORLD_ALIGNED) const {
    motion<T> pose;
    detail::check(abi::jacobian(&made_, frame, values.data(), values.size(), link, columns.data(),
                                detail::things(columns.size(), 6), pose.data()));
    return pose;
  }
  using goal = typename abi::goal;
  using reach_options = typename abi::reach_options;
  using reach_report = typename abi::reach_report;
  /* Solves the inverse kinematics of one or many configurations: moves `values`, [configuration][value], until the links of
     the goals are at `targets`, [configuration][goal]. Returns a report for each configuration, with the outcome. */
  std::vector<reach_report> reach(span<const goal> goals, span<const T> targets, span<T> values,
                                  const reach_options *options = nullptr, span<const T> posture = {}) const {
    std::size_t room = 0;
    if (goals.size() == 0) throw error(DQ8_STATUS_WEIGHT);
    if (posture.size() != 0) detail::same(posture.size(), made_.values);
    detail::check(abi::reach_scratch(&made_, goals.size(), &room));
    std::vector<T> scratch(room);
    std::vector<reach_report> reports(detail::things(targets.size(), 8 * goals.size()));
    detail::check(abi::reach(&made_, goals.data(), goals.size(), targets.data(), posture.data(), options, values.data(),
                             values.size(), scratch.data(), scratch.size(), reports.data(), reports.size()));
    return reports;
  }

 private:
  std::vector<typename abi::step> steps_;
  typename abi::mechanism made_{};
};

/* The joints and weights of the vertices of a mesh. It owns its memory, and can be moved but not copied. */
template <class T>
class skin {
  using abi = detail::abi<T>;

 public:
  /* Takes arrays [vertex][influence], `influences` for each vertex. Throws an error whose index is the wrong vertex. */
  skin(std::size_t joint_count, std::size_t influences, std::vector<std::uint16_t> joints, std::vector<T> weights)
      : joints_(std::move(joints)), weights_(std::move(weights)), joint_count_(joint_count) {
    std::size_t bad = SIZE_MAX;
    detail::same(joints_.size(), weights_.size());
    if (influences == 0) throw error(DQ8_STATUS_NO_INFLUENCES);
    const dq8_status status = abi::skin_make(joint_count, influences, joints_.data(), weights_.data(),
                                             detail::things(joints_.size(), influences), &made_, &bad);
    detail::check(status, bad);
  }
  skin(skin &&) = default;
  skin &operator=(skin &&) = default;

  /* Poses the positions of vertices by dual quaternion blends of the motions of a palette. */
  void dual(span<const T> palette, span<const T> rest, span<T> posed) const { pose(abi::skin_dual, 8, palette, rest, posed); }
  /* Poses the positions of vertices by linear blends of the 3x4 matrices of a palette. */
  void linear(span<const T> palette, span<const T> rest, span<T> posed) const {
    pose(abi::skin_linear, 12, palette, rest, posed);
  }

 private:
  template <class Function>
  void pose(Function function, std::size_t each, span<const T> palette, span<const T> rest, span<T> posed) const {
    detail::same(palette.size(), each * joint_count_), detail::same(rest.size(), posed.size());
    detail::check(function(&made_, palette.data(), joint_count_, rest.data(), nullptr, nullptr, posed.data(), nullptr, nullptr,
                           detail::things(posed.size(), 3)));
  }

  std::vector<std::uint16_t> joints_;
  std::vector<T> weights_;
  std::size_t joint_count_;
  typename abi::skin made_{};
};

} // namespace dq8

#endif
