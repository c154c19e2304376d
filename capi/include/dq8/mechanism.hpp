/* Mechanisms: trees of joints. Poses of links, Jacobians, inverse kinematics. */
#ifndef DQ8_MECHANISM_HPP
#define DQ8_MECHANISM_HPP

#include "blocks.hpp"
#include "motion.hpp"

namespace dq8 {

/* A robot of joints that have been checked once. It owns its memory, and can be moved but not copied. A mechanism that has been
   moved away throws. */
template <class T>
class mechanism {
  using abi = detail::abi<T>;

 public:
  using joint = typename abi::joint;
  using goal = typename abi::goal;
  using reach_options = typename abi::reach_options;
  using reach_report = typename abi::reach_report;
  using solution_list = typename abi::solution_list;
  using axis = std::array<T, 3>;
  using column = std::array<T, 6>; /* angular x y z, then linear x y z */
  struct jacobian_and_pose {
    std::vector<column> columns;
    motion<T> pose;
  };

  /* Joints on `parent` (-1 is the base), placed in it. */
  static joint fixed(std::int32_t parent, const motion<T> &placement = {}) {
    return abi::joint_fixed(parent, placement.data());
  }
  static joint revolute(std::int32_t parent, const motion<T> &placement, const axis &axis) {
    return abi::joint_revolute(parent, placement.data(), axis.data());
  }
  static joint prismatic(std::int32_t parent, const motion<T> &placement, const axis &axis) {
    return abi::joint_prismatic(parent, placement.data(), axis.data());
  }
  static joint screw(std::int32_t parent, const motion<T> &placement, const axis &axis, T pitch) {
    return abi::joint_screw(parent, placement.data(), axis.data(), pitch);
  }
  static joint planar(std::int32_t parent, const motion<T> &placement, const axis &normal) {
    return abi::joint_planar(parent, placement.data(), normal.data());
  }
  static joint floating(std::int32_t parent, const motion<T> &placement = {}) {
    return abi::joint_floating(parent, placement.data());
  }
  /* The joint, with limits of its value. */
  static joint limited(joint joint, T least, T greatest) {
    joint.limited = 1, joint.limits[0] = least, joint.limits[1] = greatest;
    return joint;
  }
  /* The joint, whose value follows that of `leader`: multiplier * value + offset. */
  static joint mimicking(joint joint, std::int32_t leader, T multiplier, T offset) {
    joint.mimics = 1, joint.leader = leader, joint.multiplier = multiplier, joint.offset = offset;
    return joint;
  }

  /* Throws an error whose index is the wrong joint. */
  explicit mechanism(span<const joint> joints) : steps_(joints.size()) {
    std::size_t bad = nowhere;
    const dq8_status status = abi::mechanism_make(joints.data(), joints.size(), steps_.data(), made_.fill(), &bad);
    detail::check("mechanism", status, bad);
  }

  std::size_t links() const { return made()->links; }
  std::size_t values() const { return made()->values; }
  std::size_t rates() const { return made()->rates; }

  /* Computes the pose of one link of one configuration. */
  motion<T> pose(span<const T> values, std::size_t link) const {
    one("mechanism::pose", values);
    motion<T> pose;
    detail::check("mechanism::pose", abi::mechanism_link_pose(made(), values.data(), values.size(), link, pose.data()));
    return pose;
  }
  /* Computes the poses of all links of one configuration. */
  std::vector<motion<T>> poses(span<const T> values) const {
    one("mechanism::poses", values);
    std::vector<motion<T>> poses(links());
    const span<T> to(poses);
    detail::check("mechanism::poses",
                  abi::mechanism_link_poses(made(), values.data(), values.size(), to.data(), poses.size()));
    return poses;
  }
  /* Computes the poses of all links of many configurations: [configuration][link] from [configuration][value]. */
  void poses(span<const T> values, span<T> poses) const {
    const std::size_t count = configurations("mechanism::poses", values);
    detail::length("mechanism::poses", "poses", poses.size(), 8 * links() * count);
    detail::check("mechanism::poses",
                  abi::link_poses(made(), values.data(), values.size(), poses.data(), poses.size() / 8));
  }
  /* The same in blocks, [block of configurations][link]. */
  void poses(span<const T> values, blocks<T> &poses) const {
    const std::size_t lanes = poses.has(8, "mechanism::poses"), count = configurations("mechanism::poses", values);
    detail::length("mechanism::poses", "poses, in blocks,", poses.count(), links() * ((count + lanes - 1) / lanes));
    detail::check("mechanism::poses", abi::blocks_link_poses(lanes, made(), values.data(), values.size(),
                                                             poses.numbers().data(), poses.count()));
  }
  /* Computes the Jacobian of a link of one configuration, a column for each rate, and the pose of the link. */
  jacobian_and_pose jacobian(span<const T> values, std::size_t link,
                             std::int32_t frame = DQ8_FRAME_WORLD_ALIGNED) const {
    one("mechanism::jacobian", values);
    jacobian_and_pose found{std::vector<column>(rates()), {}};
    found.pose = jacobian(values, link, span<T>(found.columns), frame);
    return found;
  }
  /* The same into memory of the caller, which holds six numbers for each rate. Returns the pose of the link. */
  motion<T> jacobian(span<const T> values, std::size_t link, span<T> columns,
                     std::int32_t frame = DQ8_FRAME_WORLD_ALIGNED) const {
    one("mechanism::jacobian", values);
    detail::length("mechanism::jacobian", "columns", columns.size(), 6 * rates());
    motion<T> pose;
    detail::check("mechanism::jacobian", abi::mechanism_link_jacobian(made(), frame, values.data(), values.size(), link,
                                                                      columns.data(), rates(), pose.data()));
    return pose;
  }

  /* Computes the manipulability of a link of one configuration: the root of the determinant of J times the transposed J. It is 0
     where the link cannot move in some direction, and the same in all frames. */
  T manipulability(span<const T> values, std::size_t link) const {
    std::vector<column> columns(rates());
    return manipulability(values, link, span<T>(columns));
  }
  /* The same with scratch memory of the caller, which holds six numbers for each rate. */
  T manipulability(span<const T> values, std::size_t link, span<T> columns) const {
    one("mechanism::manipulability", values);
    detail::length("mechanism::manipulability", "columns", columns.size(), 6 * rates());
    T volume = 0;
    detail::check("mechanism::manipulability", abi::mechanism_manipulability(made(), values.data(), values.size(), link,
                                                                             columns.data(), rates(), &volume));
    return volume;
  }
  /* Computes the rates that move a link best with the velocity `twist`, angular x y z and then linear x y z. `damping` keeps them
     small near singular configurations. */
  std::vector<T> rates_for(span<const T> values, std::size_t link, const column &twist, T damping = 0,
                           std::int32_t frame = DQ8_FRAME_WORLD_ALIGNED) const {
    std::vector<column> columns(rates());
    std::vector<T> found(rates());
    rates_for(values, link, twist, span<T>(columns), span<T>(found), damping, frame);
    return found;
  }
  /* The same into memory of the caller: `found` holds a number for each rate, and `columns`, which is scratch, six. */
  void rates_for(span<const T> values, std::size_t link, const column &twist, span<T> columns, span<T> found, T damping = 0,
                 std::int32_t frame = DQ8_FRAME_WORLD_ALIGNED) const {
    one("mechanism::rates_for", values);
    detail::length("mechanism::rates_for", "columns", columns.size(), 6 * rates());
    detail::length("mechanism::rates_for", "found", found.size(), rates());
    detail::check("mechanism::rates_for",
                  abi::mechanism_rates_for(made(), frame, values.data(), values.size(), link, twist.data(), damping,
                                           columns.data(), found.data(), rates()));
  }

  /* Computes the Jacobians and poses of some links of many configurations: poses are [configuration][link], in the order of
     `links`, and columns [configuration][link][rate], of six numbers each. */
  void jacobians(span<const T> values, span<const std::size_t> links, span<T> poses, span<T> columns,
                 std::int32_t frame = DQ8_FRAME_WORLD_ALIGNED) const {
    const std::size_t count = links.size() * configurations("mechanism::jacobians", values);
    detail::length("mechanism::jacobians", "poses", poses.size(), 8 * count);
    detail::length("mechanism::jacobians", "columns", columns.size(), 6 * count * rates());
    detail::check("mechanism::jacobians",
                  abi::link_jacobians(made(), frame, values.data(), values.size(), links.data(), links.size(), poses.data(),
                                      columns.data(), count));
  }
  /* The same in blocks, [block of configurations]. */
  void jacobians(span<const T> values, span<const std::size_t> links, blocks<T> &poses, blocks<T> &columns,
                 std::int32_t frame = DQ8_FRAME_WORLD_ALIGNED) const {
    const std::size_t lanes = poses.has(8, "mechanism::jacobians");
    const std::size_t count = (configurations("mechanism::jacobians", values) + lanes - 1) / lanes * links.size();
    detail::length("mechanism::jacobians", "poses, in blocks,", poses.count(), count);
    detail::length("mechanism::jacobians", "columns, in blocks,", columns.count(), count * rates());
    detail::check("mechanism::jacobians", columns.has(6, "mechanism::jacobians") == lanes ? DQ8_STATUS_OK : DQ8_STATUS_LANES);
    detail::check("mechanism::jacobians",
                  abi::blocks_link_jacobians(lanes, made(), frame, values.data(), values.size(), links.data(), links.size(),
                                             poses.numbers().data(), columns.numbers().data(), count));
  }

  /* A goal: a link that is to come to its target, with its rotation and its origin. */
  static goal whole(std::size_t link) { return {link, {1, 1, 1}, {1, 1, 1}, {0, 0, 0}}; }
  /* A goal: a point of a link that is to come to its target, with any rotation. */
  static goal point(std::size_t link, const std::array<T, 3> &point = {}) {
    return {link, {0, 0, 0}, {1, 1, 1}, {point[0], point[1], point[2]}};
  }
  static reach_options default_options() {
    reach_options options;
    detail::check("mechanism::default_options", abi::mechanism_reach_options(&options));
    return options;
  }
  /* Solves the inverse kinematics of one configuration: moves `values` until the links of the goals are at `targets`, a motion
     for each goal. Returns a report with the outcome. `posture` is preferred where the goals leave freedom. */
  reach_report reach_one(span<const goal> goals, span<const T> targets, span<T> values,
                         const reach_options &options = default_options(), span<const T> posture = {}) const {
    one("mechanism::reach_one", values);
    std::vector<T> scratch = scratch_of("mechanism::reach_one", abi::mechanism_reach_scratch, goals, posture);
    detail::length("mechanism::reach_one", "targets", targets.size(), 8 * goals.size());
    reach_report report{};
    detail::check("mechanism::reach_one",
                  abi::mechanism_reach(made(), goals.data(), targets.data(), goals.size(), detail::maybe(posture), &options,
                                       values.data(), values.size(), scratch.data(), scratch.size(), &report));
    return report;
  }
  /* The same of many configurations on lanes: moves `values`, [configuration][value], until the links of the goals are at
     `targets`, [configuration][goal]. Returns a report for each configuration. */
  std::vector<reach_report> reach(span<const goal> goals, span<const T> targets, span<T> values,
                                  const reach_options &options = default_options(), span<const T> posture = {}) const {
    const std::size_t count = configurations("mechanism::reach", values);
    std::vector<T> scratch = scratch_of("mechanism::reach", abi::reach_scratch, goals, posture);
    detail::length("mechanism::reach", "targets", targets.size(), 8 * goals.size() * count);
    std::vector<reach_report> reports(count);
    detail::check("mechanism::reach",
                  abi::reach(made(), goals.data(), goals.size(), targets.data(), detail::maybe(posture), &options,
                             values.data(), values.size(), scratch.data(), scratch.size(), reports.data(), count));
    return reports;
  }
  /* Finds all solutions of an arm of six hinges for each target: values of its hinges that bring the link of the goal `whole` there.
     `starts` has six values for each target; the nearest solution to them comes first. Throws an error whose index is the
     wrong target. */
  std::vector<solution_list> solutions(const goal &whole, span<const T> targets, span<const T> starts) const {
    const std::size_t count = detail::things("mechanism::solutions", "targets", targets.size(), 8);
    detail::length("mechanism::solutions", "starts", starts.size(), 6 * count);
    std::size_t room = 0, bad = nowhere;
    detail::check("mechanism::solutions", abi::solutions_scratch(made(), &room));
    std::vector<T> scratch(room);
    std::vector<solution_list> found(count);
    const dq8_status status = abi::solutions(made(), &whole, targets.data(), starts.data(), scratch.data(), scratch.size(),
                                             found.data(), count, &bad);
    detail::check("mechanism::solutions", status, bad);
    return found;
  }

 private:
  const typename abi::mechanism *made() const { return made_.get("mechanism"); }
  template <class Values>
  void one(const char *name, Values given) const {
    detail::length(name, "values", given.size(), values());
  }
  template <class Values>
  std::size_t configurations(const char *name, Values given) const {
    return detail::things(name, "values", given.size(), values());
  }
  template <class Function>
  std::vector<T> scratch_of(const char *name, Function function, span<const goal> goals, span<const T> posture) const {
    detail::length_if(name, "posture", posture.size(), values());
    std::size_t room = 0;
    detail::check(name, function(made(), goals.size(), &room));
    return std::vector<T>(room);
  }

  std::vector<typename abi::step> steps_;
  detail::made<typename abi::mechanism> made_;
};

} // namespace dq8

#endif
