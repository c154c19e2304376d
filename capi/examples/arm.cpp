/*
 * An arm, a skeleton, a trajectory and a sleeve in C++17, with float and with double.
 *
 *     c++ -std=c++17 arm.cpp $(pkg-config --cflags --libs dq8)
 */
#include <cmath>
#include <cstdio>

#include "dq8.hpp"

static int failures = 0;

static void check(bool right, const char *what) {
  if (!right) {
    std::printf("wrong: %s\n", what);
    failures++;
  }
}

static bool near(double a, double b) { return std::fabs(a - b) < 1e-6; }

/* What `call` is refused with. */
template <class Call>
static dq8_status refused(Call call, std::size_t index = SIZE_MAX) {
  try {
    call();
  } catch (const dq8::error &error) {
    check(error.index == index, "the index of an error");
    return error.status;
  }
  return DQ8_STATUS_OK;
}

template <class T>
static void all(typename dq8::mechanism<T>::joint (*revolute)(std::int32_t, const T *, const T *)) {
  const T z[3] = {0, 0, 1}, bone[8] = {0, 0, 0, 1, T(0.5), 0, 0, 0}, along[3] = {1, 0, 0};
  std::vector joints{revolute(-1, nullptr, z), revolute(0, bone, z)};
  dq8::mechanism<T> arm(joints);
  const dq8::mechanism<T> moved(std::move(arm));
  const std::array<T, 2> values{T(0.5), T(-0.25)};

  /* The tip is a bone beyond the second joint. */
  std::array<T, 3> tip{};
  std::array<T, 12> columns{};
  dq8::points(moved.jacobian(values, 1, columns), along, tip);
  check(near(tip[0], std::cos(0.5) + std::cos(0.25)) && near(tip[1], std::sin(0.5) + std::sin(0.25)), "the tip");
  check(near(columns[2], 1) && near(columns[8], 1), "both joints turn the tip about z");
  std::vector<T> poses(3 * 2 * 8), many{values[0], values[1], 0, 0, 1, 1};
  moved.poses(many, poses);
  check(moved.links() == 2 && near(poses[8 + 4], moved.pose(values, 1)[4]), "many configurations");

  /* The tips of three configurations are reached again, from others, at the points that they have; the mean of two. */
  const typename dq8::mechanism<T>::goal goal{1, {0, 0, 0}, {1, 1, 0}, {1, 0, 0}};
  std::vector<T> targets, start{T(0.4), T(-0.2), T(0.1), T(0.2), T(0.9), T(0.8)}, again(poses.size());
  for (std::size_t i = 0; i < 3; i++) {
    dq8::motion<T> at{0, 0, 0, 1};
    dq8::points(dq8::span<const T>(&poses[16 * i + 8], 8), along, tip);
    for (std::size_t k = 0; k < 3; k++) at[4 + k] = tip[k] / 2;
    targets.insert(targets.end(), at.begin(), at.end());
  }
  for (const auto &report : moved.reach({&goal, 1}, targets, start)) check(report.outcome == DQ8_OUTCOME_CONVERGED, "reached");
  moved.poses(start, again);
  dq8::points(dq8::span<const T>(&again[8], 8), along, tip);
  check(std::fabs(tip[0] / 2 - targets[4]) < 1e-4 && std::fabs(tip[1] / 2 - targets[5]) < 1e-4, "the tip that was asked for");
  const auto [mean, converged] = dq8::mean(dq8::span<const T>(targets.data(), 16));
  check(converged && near(mean[4], (targets[4] + targets[12]) / 2), "the mean of two translations");
  check(near(dq8::mean(targets, std::vector<T>{0, 0, 2}).first[4], targets[20]), "the weights of a mean");

  const std::int32_t parents[2] = {-1, 0};
  std::vector<T> locals{bone, bone + 8}, models(16), palette(16), binds(16), square(16);
  locals.insert(locals.end(), bone, bone + 8);
  dq8::local_to_model(parents, locals, models);
  check(near(models[8 + 4], 1), "two bones make two lengths");
  dq8::inverse(models, binds);
  dq8::palette(parents, locals, binds, models, palette);
  check(near(palette[8 + 3], 1) && near(palette[8 + 4], 0), "the palette of the bind pose moves nothing");
  dq8::mul(models, binds, square);
  check(near(square[3], 1) && near(square[4], 0), "a motion by its inverse");
  dq8::sclerp(palette, models, 0.5, square);
  check(near(square[8 + 4], 0.5), "half of the way");
  dq8::nlerp(palette, models, 0.25, square);
  dq8::normalize(square, square);
  check(near(square[8 + 4], 0.25), "a quarter of the way");

  const std::array<T, 2> times{0, 2};
  const std::vector<T> at{1};
  std::array<T, 8> between{};
  std::array<T, 12> matrix{};
  dq8::resample(times, models, at, between);
  dq8::matrices_3x4(between, matrix);
  check(near(matrix[3], 1.5), "between two poses");

  const dq8::skin<T> sleeve(2, 2, {0, 1, 1, 0}, {T(0.5), T(0.5), 1, 0});
  const std::vector<T> rest{0, 0, 0, 1, 0, 0};
  std::vector<T> posed(6);
  sleeve.dual(models, rest, posed);
  check(near(posed[0], 1.5) && near(posed[3], 3), "vertices between joints");

  joints[1].axis[2] = 2;
  check(refused([&] { dq8::mechanism<T> wrong(joints); }, 1) == DQ8_STATUS_AXIS, "an axis that is too long");
  check(refused([&] { dq8::mul(models, binds, tip); }) == DQ8_STATUS_LENGTH, "another length");
  check(refused([&] { dq8::resample(std::array<T, 2>{1, 1}, models, at, between); }, 1) == DQ8_STATUS_TIMES, "times");
  check(refused([&] { dq8::skin<T>(1, 1, {0, 1}, {1, 1}); }, 1) == DQ8_STATUS_JOINT_OUT_OF_RANGE, "no such joint");
  check(refused([&] { moved.reach({&goal, 1}, targets, many); }) == DQ8_STATUS_OK, "as many values");
  check(refused([&] { moved.reach({&goal, 1}, targets, columns); }) == DQ8_STATUS_LENGTH, "other values");
  check(refused([&] { dq8::mean(std::vector<T>()); }) == DQ8_STATUS_NO_INFLUENCES, "nothing");
  check(refused([&] { moved.pose(values, 2); }) == DQ8_STATUS_NO_LINK, "no such link");
  check(refused([&] { sleeve.linear(models, rest, posed); }) == DQ8_STATUS_LENGTH, "motions where matrices belong");
}

int main() {
  all<float>(dq8_joint_revolute_f32);
  all<double>(dq8_joint_revolute_f64);
  std::puts(failures == 0 ? "PASS" : "FAIL");
  return failures;
}
