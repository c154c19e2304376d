/*
 * Every function of C has a door in C++: this program goes through all of them, with float and with double, and compares what
 * comes out with what a motion or another door says. It names no function of C, so those that its object file refers to are
 * those that have a door; capi/test.sh compares them with the exports of the library.
 */
#include <cmath>
#include <cstdio>
#include <cstring>
#include <tuple>

#if __cplusplus >= 202002L
#include <span>
#endif

#include "dq8.hpp"

static int failures = 0;

static void check(bool right, const char *name) {
  if (!right) {
    std::printf("wrong: %s\n", name);
    failures++;
  }
}

template <class T>
static bool near(dq8::span<const T> a, dq8::span<const T> b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); i++) {
    if (!(std::fabs(a[i] - b[i]) < T(2e-5))) return false;
  }
  return true;
}

/* Whether `call` is refused with a status, an index, and a text that has `word`. */
template <class Call>
static bool refused(dq8_status status, const char *word, Call call, std::size_t index = dq8::nowhere) {
  try {
    call();
  } catch (const dq8::error &error) {
    const bool right = error.status == status && error.index == index && std::strstr(error.what(), word) != nullptr;
    if (!right) std::printf("%s, not %s\n", error.what(), word);
    return right;
  }
  return false;
}

template <class T>
static T wave(std::size_t i) {
  return T(std::sin(1.7 * double(i) + 0.3));
}

/* Random motions, and other things of some numbers. */
template <class T>
static std::vector<dq8::motion<T>> motions(std::size_t count, std::size_t seed) {
  std::vector<dq8::motion<T>> motions;
  for (std::size_t i = 0; i < count; i++) {
    std::array<T, 8> numbers;
    for (std::size_t k = 0; k < 8; k++) numbers[k] = wave<T>(13 * i + k + 101 * seed);
    motions.push_back(dq8::motion<T>(numbers).normalized());
  }
  return motions;
}
template <class T>
static std::vector<T> numbers(std::size_t count, std::size_t seed) {
  std::vector<T> numbers(count);
  for (std::size_t i = 0; i < count; i++) numbers[i] = wave<T>(i + 77 * seed);
  return numbers;
}

/* An input of a function on arrays: `each` numbers for a thing, plain and in blocks. */
template <class T>
struct given {
  std::vector<T> plain;
  std::size_t each;
  given(dq8::span<const T> all, std::size_t of_each) : plain(all.begin(), all.end()), each(of_each) {}
  dq8::blocks<T> blocks() const {
    const std::size_t lanes = 32 / sizeof(T), count = plain.size() / each;
    dq8::blocks<T> blocks(lanes, each, (count + lanes - 1) / lanes);
    for (std::size_t i = 0; i < count; i++) {
      for (std::size_t k = 0; k < each; k++) blocks.at(i / lanes, i % lanes, k) = plain[each * i + k];
    }
    return blocks;
  }
};

/* Calls a function on arrays, plain and in blocks, and compares with the answers. */
template <class T, class Call, class... In>
static void arrays(const char *name, std::size_t each, const std::vector<T> &answers, Call call, const In &...in) {
  std::vector<T> out(answers.size());
  call(in.plain..., out);
  check(near<T>(out, answers), name);
  given<T> empty(std::vector<T>(answers.size()), each);
  dq8::blocks<T> blocks = empty.blocks();
  call(in.blocks()..., blocks);
  const std::size_t lanes = blocks.lanes();
  for (std::size_t i = 0; i < out.size() / each; i++) {
    for (std::size_t k = 0; k < each; k++) {
      if (std::fabs(blocks.at(i / lanes, i % lanes, k) - out[each * i + k]) > T(2e-5)) check(false, name);
    }
  }
  out.push_back(0);
  check(refused(DQ8_STATUS_LENGTH, each == 1 ? "has length" : "out has length", [&] { call(in.plain..., out); }), name);
}

/* The answers of `one` for each index, one after the other. */
template <class T, class One>
static std::vector<T> each(std::size_t count, One one) {
  std::vector<T> all;
  for (std::size_t i = 0; i < count; i++) {
    const auto answer = one(i);
    const dq8::span<const T> numbers(answer);
    all.insert(all.end(), numbers.begin(), numbers.end());
  }
  return all;
}

template <class T>
static void on_arrays() {
  const std::size_t n = 19;
  using motion = dq8::motion<T>;
  const auto a = motions<T>(n, 1), b = motions<T>(n, 2);
  const auto parts = numbers<T>(n, 3), six = numbers<T>(6 * n, 4), three = numbers<T>(3 * n, 5), four = numbers<T>(4 * n, 6);
  const given<T> as(a, 8), bs(b, 8), ts(parts, 1), sixes(six, 6), threes(three, 3), fours(four, 4);
  const auto of_six = [&](std::size_t i) { return std::array<T, 6>{six[6 * i], six[6 * i + 1], six[6 * i + 2], six[6 * i + 3], six[6 * i + 4], six[6 * i + 5]}; };
  const auto of_three = [&](std::size_t i) { return std::array<T, 3>{three[3 * i], three[3 * i + 1], three[3 * i + 2]}; };
  const auto of_four = [&](std::size_t i) { return std::array<T, 4>{four[4 * i], four[4 * i + 1], four[4 * i + 2], four[4 * i + 3]}; };
  const auto one = [](T number) { return std::array<T, 1>{number}; };
#define CALL(...) [&](auto &&x, auto &&...more) { __VA_ARGS__; }
#define EACH(answer) each<T>(n, [&](std::size_t i) { return answer; })
  arrays("mul", 8, EACH(a[i] * b[i]), CALL(dq8::mul(x, more...)), as, bs);
  arrays("normalize", 8, EACH(a[i]), CALL(dq8::normalize(x, more...)), as);
  arrays("inverse", 8, EACH(a[i].inverse()), CALL(dq8::inverse(x, more...)), as);
  arrays("conjugate", 8, EACH(a[i].conjugate()), CALL(dq8::conjugate(x, more...)), as);
  const auto t = T(0.3);
  const auto between = [&](auto law) {
    return [=](auto &&x, auto &&y, auto &&out) { law(x, y, out); };
  };
  arrays("nlerp", 8, EACH(a[i].nlerp(b[i], t)), between([&](auto &x, auto &y, auto &out) { dq8::nlerp(x, y, t, out); }), as, bs);
  arrays("sclerp", 8, EACH(a[i].sclerp(b[i], t)), between([&](auto &x, auto &y, auto &out) { dq8::sclerp(x, y, t, out); }), as, bs);
  arrays("nlerp_each", 8, EACH(a[i].nlerp(b[i], parts[i])), CALL(dq8::nlerp_each(x, more...)), as, bs, ts);
  arrays("sclerp_each", 8, EACH(a[i].sclerp(b[i], parts[i])), CALL(dq8::sclerp_each(x, more...)), as, bs, ts);
  const auto middle = [&](std::size_t i, T part) {
    const auto p = a[i].translation(), q = b[i].translation();
    const auto turn = motion::rotation_by(a[i].rotation()).sclerp(motion::rotation_by(b[i].rotation()), part).rotation();
    return motion(turn, {p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1]), p[2] + part * (q[2] - p[2])});
  };
  const auto signed_like = [](motion m, const motion &other) {
    T dot = 0;
    for (std::size_t k = 0; k < 4; k++) dot += m[k] * other[k];
    for (std::size_t k = 0; k < 8; k++) m[k] = dot < 0 ? -m[k] : m[k];
    return m;
  };
  std::vector<motion> mixed(n), mixed_each(n);
  dq8::slerp_lerp(a, b, t, mixed), dq8::slerp_lerp_each(a, b, parts, mixed_each);
  arrays("slerp_lerp", 8, EACH(signed_like(middle(i, t), mixed[i])), between([&](auto &x, auto &y, auto &out) { dq8::slerp_lerp(x, y, t, out); }), as, bs);
  arrays("slerp_lerp_each", 8, EACH(signed_like(middle(i, parts[i]), mixed_each[i])), CALL(dq8::slerp_lerp_each(x, more...)), as, bs, ts);
  arrays("pow_each", 8, EACH(a[i].pow(parts[i])), CALL(dq8::pow_each(x, more...)), as, ts);
  arrays("exp", 8, EACH(motion::exp(of_six(i))), CALL(dq8::exp(x, more...)), sixes);
  arrays("from_twist", 8, EACH(motion().integrate_body(of_six(i), 1)), CALL(dq8::from_twist(x, more...)), sixes);
  arrays("integrate_body", 8, EACH(a[i].integrate_body(of_six(i), t)), [&](auto &&x, auto &&y, auto &&out) { dq8::integrate_body(x, y, t, out); }, as, sixes);
  arrays("log", 6, EACH(a[i].log()), CALL(dq8::log(x, more...)), as);
  arrays("to_twist", 6, EACH(a[i].to_twist()), CALL(dq8::to_twist(x, more...)), as);
  arrays("angles", 1, EACH(one(a[i].angle_to(b[i]))), CALL(dq8::angles(x, more...)), as, bs);
  arrays("distances", 1, EACH(one(a[i].distance_to(b[i]))), CALL(dq8::distances(x, more...)), as, bs);
  arrays("points_each", 3, EACH(a[i].point(of_three(i))), CALL(dq8::points_each(x, more...)), as, threes);
  arrays("vectors_each", 3, EACH(a[i].direction(of_three(i))), CALL(dq8::vectors_each(x, more...)), as, threes);
  arrays("lines_each", 6, EACH(a[i].move_line(of_six(i))), CALL(dq8::lines_each(x, more...)), as, sixes);
  arrays("planes_each", 4, EACH(a[i].move_plane(of_four(i))), CALL(dq8::planes_each(x, more...)), as, fours);
  arrays("twists_each", 6, EACH(a[i].adjoint(of_six(i))), CALL(dq8::twists_each(x, more...)), as, sixes);
  arrays("points", 3, EACH(a[0].point(of_three(i))), CALL(dq8::points(a[0], x, more...)), threes);
  arrays("vectors", 3, EACH(a[0].direction(of_three(i))), CALL(dq8::vectors(a[0], x, more...)), threes);
  arrays("matrices_3x4", 12, EACH(a[i].to_matrix_3x4()), CALL(dq8::matrices_3x4(x, DQ8_MATRIX_ORDER_ROWS, more...)), as);
  arrays("matrices_4x4", 16, EACH(a[i].to_matrix_4x4()), CALL(dq8::matrices_4x4(x, DQ8_MATRIX_ORDER_ROWS, more...)), as);

#if __cplusplus >= 202002L
  std::vector<T> by_span(3 * n);
  dq8::points(a[0], std::span<const T>(three), std::span<T>(by_span));
  check(near<T>(dq8::span<const T>(by_span.data(), 3), a[0].point(of_three(0))), "std::span");
#endif

  motion end;
  std::vector<motion> products(n), back(n);
  for (std::size_t i = 0; i < n; i++) products[i] = end = end * a[i];
  dq8::chain_products(a, back);
  check(near<T>(back, products), "chain_products");
  auto chain = dq8::blocks<T>::pack_chain(32 / sizeof(T), a);
  auto along = dq8::blocks<T>(chain.lanes(), 8, chain.count());
  dq8::chain_products(chain, along);
  along.unpack_chain(back);
  check(near<T>(back, products), "chain_products in blocks");

  check(refused(DQ8_STATUS_LENGTH, "dq8::mul: b has length 8, and must have length 152", [&] { dq8::mul(a, b[0], back); }), "b");
  check(refused(DQ8_STATUS_LENGTH, "dq8::points: motion has length 152", [&] { dq8::points(a, three, std::vector<T>(3 * n)); }), "motion");
  check(refused(DQ8_STATUS_LENGTH, "b has length", [&] { dq8::mul(along, dq8::blocks<T>(along.lanes(), 8, 1), chain); }), "blocks of b");
  check(refused(DQ8_STATUS_LANES, "a has blocks of", [&] { dq8::mul(dq8::blocks<T>(64 / sizeof(T), 8, chain.count()), chain, chain); }), "lanes of a");
  check(refused(DQ8_STATUS_LENGTH, "3 components", [&] { dq8::mul(threes.blocks(), chain, chain); }), "points are no motions");
  check(refused(DQ8_STATUS_LANES, "lanes", [&] { dq8::blocks<T>(5, 8, 1); }), "blocks of five");
  dq8::blocks<T> taken(std::move(along));
  check(refused(DQ8_STATUS_LENGTH, "blocks of 0 components", [&] { dq8::mul(taken, along, chain); }), "moved blocks");
}

template <class T>
static void on_motions() {
  using motion = dq8::motion<T>;
  const motion a = motions<T>(1, 8)[0], b = motions<T>(1, 9)[0], identity = motion::identity();
  check(near<T>(identity, motion()) && a != b && a.is_unit() && !motion({2, 0, 0, 0, 0, 0, 0, 0}).is_unit(), "identity, is_unit");
  check(near<T>((a * b).point({1, 2, 3}), a.point(b.point({1, 2, 3}))), "b acts first");
  check(near<T>(motion(a.rotation(), a.translation()), a) && near<T>(motion::from_matrix(a.to_matrix_3x4()), a) &&
            near<T>(motion::from_matrix(a.to_matrix_4x4()), a) && near<T>(motion::from_screw(a.to_screw()), a) &&
            near<T>(motion::exp(a.log()), a),
        "there and back");
  check(near<T>(a.inverse() * a, identity) && near<T>(a.conjugate(), a.inverse()), "inverses");
  const auto turn = [](std::size_t axis, T angle) {
    std::array<T, 4> turned{0, 0, 0, std::cos(angle / 2)};
    turned[axis] = std::sin(angle / 2);
    return motion::rotation_by(turned);
  };
  const std::array<T, 3> angles{T(0.3), T(-0.2), T(0.1)};
  check(near<T>(motion::from_euler("ZYX", angles), turn(2, angles[0]) * turn(1, angles[1]) * turn(0, angles[2])) &&
            near<T>(motion::from_euler("xyz", {angles[2], angles[1], angles[0]}), motion::from_euler("ZYX", angles)) &&
            near<T>(motion::from_euler("ZXZ", {T(0.3), T(0.2), T(0.1)}), turn(2, T(0.3)) * turn(0, T(0.2)) * turn(2, T(0.1))) &&
            near<T>(motion::from_euler("ZYX", angles).to_euler("ZYX"), angles),
        "Euler angles");
  for (const char *order : {"ZYx", "ZZX", "ZY", "ZYXZ", "", "abc"}) {
    check(refused(DQ8_STATUS_UNKNOWN_VALUE, "motion::from_euler", [&] { motion::from_euler(order, angles); }), "no order");
  }
  check(refused(DQ8_STATUS_UNKNOWN_VALUE, "motion::to_euler", [&] { a.to_euler("zyz "); }), "no order of angles");
  std::vector<std::array<T, 3>> corners{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {1, 1, 1}}, there;
  for (const auto &corner : corners) there.push_back(a.point(corner));
  const auto fit = dq8::fit(corners, there);
  check(near<T>(fit.motion, a) && fit.quality.rank == 3 && fit.quality.rms < T(1e-5) && fit.quality.mirrored == 0 && fit.quality.scale == 1, "a fit");
  for (auto &point : there) point = {2 * point[0], 2 * point[1], 2 * point[2]};
  check(std::fabs(dq8::fit(corners, there, {}, true).quality.scale - 2) < T(1e-5), "a fit with a scale");
  for (auto &point : there) point[2] = -point[2];
  check(dq8::fit(corners, there, {}, true).quality.mirrored == 1, "points of the other hand");
  check(refused(DQ8_STATUS_WEIGHT, "fit", [&] { dq8::fit(corners, there, {T(1), T(1), T(-1), T(1), T(1)}); }, 2), "a weight");
  check(refused(DQ8_STATUS_AMBIGUOUS, "fit", [&] { dq8::fit(std::vector<T>(6), std::vector<T>(6)); }), "points in a point");
  check(refused(DQ8_STATUS_LENGTH, "moved has length 3", [&] { dq8::fit(corners, corners[0]); }), "moved points");
  const auto log = a.log(), twist = a.to_twist();
  check(std::fabs(twist[1] - 2 * log[1]) < T(1e-5) && near<T>(motion().integrate_body(twist, 1), a), "the twist is twice the log");
  check(near<T>(a.sclerp(b, 0), a) && near<T>(a.nlerp(b, 0), a) && near<T>(a.pow(1), a), "ends");
  check(near<T>(motion::blend(a, {T(1)}), a) && near<T>(motion::mean(a).first, a) && motion::mean(a, {T(2)}).second, "one of one");
  const auto moved = motion::translation_by({1, 2, 3});
  check(near<T>(moved.direction({0, 0, 1}), std::array<T, 3>{0, 0, 1}) && near<T>(moved.move_plane({0, 0, 1, 0}), std::array<T, 4>{0, 0, 1, moved.move_plane({0, 0, 1, 0})[3]}), "directions");
  check(std::fabs(moved.distance_to(identity) - std::sqrt(T(14))) < T(1e-5) && moved.angle_to(identity) == 0, "distances");
  check(near<T>(moved.adjoint({0, 0, 1, 0, 0, 0}), std::array<T, 6>{0, 0, 1, 2, -1, 0}), "the adjoint");
  check(near<T>(moved.move_line({0, 0, 1, 0, 0, 0}), std::array<T, 6>{0, 0, 1, 2, -1, 0}), "a line");
  check(refused(DQ8_STATUS_NOT_NORMALIZABLE, "motion::normalized", [] { motion(std::array<T, 8>{}).normalized(); }), "nothing");
  check(refused(DQ8_STATUS_NO_INVERSE, "motion::inverse", [] { motion(std::array<T, 8>{}).inverse(); }), "no inverse");
  check(refused(DQ8_STATUS_LENGTH, "matrix has length 3", [] { motion::from_matrix({T(1), T(2), T(3)}); }), "no matrix");
  check(refused(DQ8_STATUS_LENGTH, "weights has length 2", [&] { motion::mean(a, {T(1), T(2)}); }), "weights");
}

template <class T>
static void on_skeletons() {
  using motion = dq8::motion<T>;
  const std::vector<std::int32_t> parents{-1, 0, 1, 0};
  const std::size_t joints = 4, instances = 3, count = joints * instances, lanes = 32 / sizeof(T);
  const dq8::skeleton skeleton(parents);
  const auto locals = motions<T>(count, 10), binds = motions<T>(joints, 11);
  const motion root = motions<T>(1, 12)[0];
  std::vector<motion> models(count), back(count), palette(count), wanted(count);
  for (std::size_t i = 0; i < count; i++) {
    const std::int32_t parent = parents[i % joints];
    wanted[i] = (parent < 0 ? root : wanted[i - i % joints + std::size_t(parent)]) * locals[i];
  }
  const auto blocks_of = [&](const std::vector<motion> &of) { return dq8::blocks<T>::pack(lanes, joints, of); };
  auto in_blocks = blocks_of(locals), out = blocks_of(locals), others = blocks_of(locals);
  const auto is = [&](const char *name, const auto &answers) {
    std::vector<motion> all(count);
    out.unpack(joints, all);
    check(near<T>(models, answers) && near<T>(all, answers), name);
  };
  skeleton.local_to_model(locals, models, root), skeleton.local_to_model(in_blocks, out, root);
  is("local_to_model", wanted);
  auto of_models = blocks_of(wanted);
  skeleton.model_to_local(wanted, models, root), skeleton.model_to_local(of_models, out, root);
  is("model_to_local", locals);
  std::vector<T> turns, sevens, offsets;
  for (std::size_t i = 0; i < count; i++) {
    const auto turn = locals[i].rotation();
    const auto at = locals[i % joints].translation(), own = locals[i].translation();
    turns.insert(turns.end(), turn.begin(), turn.end());
    sevens.insert(sevens.end(), turn.begin(), turn.end()), sevens.insert(sevens.end(), own.begin(), own.end());
    if (i < joints) offsets.insert(offsets.end(), at.begin(), at.end());
  }
  const auto components = [&](const std::vector<T> &plain, std::size_t each) {
    dq8::blocks<T> blocks(lanes, each, joints);
    for (std::size_t i = 0; i < count; i++) {
      for (std::size_t k = 0; k < each; k++) blocks.at(i % joints, i / joints, k) = plain[each * i + k];
    }
    return blocks;
  };
  skeleton.rotations_translations_to_model(sevens, models, root);
  skeleton.rotations_translations_to_model(components(sevens, 7), out, root);
  is("rotations_translations_to_model", wanted);
  std::vector<motion> boned(count);
  for (std::size_t i = 0; i < count; i++) boned[i] = motion(locals[i].rotation(), locals[i % joints].translation());
  skeleton.local_to_model(std::vector<motion>(boned), boned, root);
  skeleton.rotations_to_model(turns, offsets, models, root), skeleton.rotations_to_model(components(turns, 4), offsets, out, root);
  is("rotations_to_model", boned);
  skeleton.palette(locals, binds, models, palette, root), skeleton.palette(in_blocks, binds, out, others, root);
  is("palette: models", wanted);
  std::vector<motion> moving(count), unpacked(count);
  for (std::size_t i = 0; i < count; i++) moving[i] = wanted[i] * binds[i % joints];
  others.unpack(joints, unpacked);
  check(near<T>(palette, moving) && near<T>(unpacked, moving), "palette");
  std::vector<T> matrices(12 * count), wanted_matrices(12 * count);
  dq8::blocks<T> matrix_blocks(lanes, 12, joints);
  dq8::matrices_3x4(moving, DQ8_MATRIX_ORDER_ROWS, wanted_matrices);
  skeleton.palette_matrices(locals, binds, models, matrices, root), skeleton.palette_matrices(in_blocks, binds, out, matrix_blocks, root);
  check(near<T>(matrices, wanted_matrices) && std::fabs(matrix_blocks.at(1, 2, 3) - matrices[12 * (2 * joints + 1) + 3]) < T(1e-5), "palette_matrices");
  const dq8::plan plan(skeleton);
  std::vector<motion> plainly(count);
  plan.local_to_model(locals, models), skeleton.local_to_model(locals, plainly);
  check(near<T>(models, plainly), "a plan");

  check(refused(DQ8_STATUS_PARENT_NOT_BEFORE, "skeleton", [] { dq8::skeleton({-1, 1}); }, 1), "parents");
  check(refused(DQ8_STATUS_PARENT_OUT_OF_RANGE, "plan", [] { dq8::plan({-1, 0, 7}); }, 2), "parents of a plan");
  check(refused(DQ8_STATUS_LENGTH, "locals has length 8", [&] { skeleton.local_to_model(locals[0], models); }), "locals");
  check(refused(DQ8_STATUS_LENGTH, "root has length 3", [&] { skeleton.local_to_model(locals, models, {1, 2, 3}); }), "root");
  check(refused(DQ8_STATUS_LENGTH, "inverse_binds has length 8", [&] { skeleton.palette(locals, root, models, palette); }), "binds");
  check(refused(DQ8_STATUS_LENGTH, "offsets has length 3", [&] { skeleton.rotations_to_model(turns, {1, 2, 3}, models); }), "offsets");
  dq8::skeleton gone({-1}), stays(std::move(gone));
  check(stays.joints() == 1 && refused(DQ8_STATUS_UNKNOWN_VALUE, "skeleton: this object has been moved away", [&] { gone.joints(); }), "moved skeleton");
  auto &same = stays;
  stays = std::move(same);
  check(refused(DQ8_STATUS_UNKNOWN_VALUE, "skeleton: this object has been moved away", [&] { stays.joints(); }), "a skeleton moved to itself");
  dq8::plan old(skeleton), kept(std::move(old));
  check(refused(DQ8_STATUS_UNKNOWN_VALUE, "plan: this object has been moved away", [&] { old.local_to_model(locals, models); }), "moved plan");
}

template <class T>
static void on_meshes() {
  using motion = dq8::motion<T>;
  const std::vector<std::uint16_t> joints{0, 1, 1, 0};
  const std::vector<T> weights{T(0.5), T(0.5), 1, 0}, rest{0, 0, 0, 1, 0, 0}, normals{0, 0, 1, 0, 1, 0}, shares{1, 0};
  const std::vector<motion> palette{motion(), motion::translation_by({0, 0, 2})};
  std::vector<T> matrices(24), models(32), split(24), products(24), inverse(32), posed(6), posed_normals(6), posed_tangents(6);
  std::vector<motion> motions(2);
  dq8::matrices_3x4(palette, DQ8_MATRIX_ORDER_ROWS, matrices), dq8::matrices_4x4(palette, DQ8_MATRIX_ORDER_COLUMNS, models);
  dq8::matrices_4x4(std::vector<motion>(2), DQ8_MATRIX_ORDER_COLUMNS, inverse);
  dq8::skin_products(models, inverse, DQ8_MATRIX_ORDER_COLUMNS, products);
  dq8::skin_split(products, motions, split);
  check(near<T>(products, matrices) && near<T>(motions, palette) && split[0] == 1, "palettes of an engine");
  const dq8::skin<T> sleeve(2, 2, joints, weights);
  const std::vector<T> wanted{0, 0, 1, 1, 0, 2};
  const auto is = [&](const char *name) {
    check(near<T>(posed, wanted) && near<T>(posed_normals, normals) && near<T>(posed_tangents, rest), name);
    posed.assign(6, 9), posed_normals.assign(6, 9), posed_tangents.assign(6, 9);
  };
  const typename dq8::skin<T>::rest from{rest, normals, rest};
  const dq8::surface<T> to{posed, posed_normals, posed_tangents};
  sleeve.linear(matrices, from, to), is("linear");
  sleeve.dual(palette, from, to), is("dual");
  sleeve.stretched(motions, split, from, to), is("stretched");
  sleeve.mixed(matrices, palette, shares, from, to), is("mixed");

  /* Vertices of five numbers: one that is nothing, a position, and another that is nothing. */
  const dq8::skin<T> buffered(2, 2, {7, 0, 1, 7, 1, 0}, {3, 1}, {T(0.5), T(0.5), 1, 0}, {2, 0});
  const std::vector<T> vertices{9, 0, 0, 0, 9, 9, 1, 0, 0, 9}, moved{9, 0, 0, 1, 9, 9, 1, 0, 2, 9};
  std::vector<T> buffer(10, 9);
  const dq8_vertex_fields fields{5, 1, -1, -1};
  const typename dq8::skin<T>::rest_buffer source{vertices, fields};
  const dq8::vertex_buffer<T> target{buffer, fields};
  const auto is_buffer = [&](const char *name) { check(near<T>(buffer, moved), name), buffer.assign(10, 9); };
  buffered.linear(matrices, source, target), is_buffer("linear, interleaved");
  buffered.dual(palette, source, target), is_buffer("dual, interleaved");
  buffered.stretched(motions, split, source, target), is_buffer("stretched, interleaved");
  buffered.mixed(matrices, palette, shares, source, target), is_buffer("mixed, interleaved");

  check(refused(DQ8_STATUS_JOINT_OUT_OF_RANGE, "skin", [] { dq8::skin<T>(1, 1, {0, 1}, {1, 1}); }, 1), "no such joint");
  check(refused(DQ8_STATUS_LENGTH, "weights has length 1", [] { dq8::skin<T>(1, 1, {0, 0}, {1}); }), "weights of a skin");
  check(refused(DQ8_STATUS_LENGTH, "matrices has length 16", [&] { sleeve.linear(palette, from, to); }), "motions are no matrices");
  check(refused(DQ8_STATUS_LENGTH, "the posed normals has length 0", [&] { sleeve.dual(palette, from, {posed, {}, posed_tangents}); }), "posed normals");
  check(refused(DQ8_STATUS_LENGTH, "shares has length 1", [&] { sleeve.mixed(matrices, palette, {T(1)}, from, to); }), "shares");
  dq8::skin<T> gone(2, 2, joints, weights), stays(std::move(gone));
  check(stays.vertices() == 2 && refused(DQ8_STATUS_UNKNOWN_VALUE, "skin: this object", [&] { gone.dual(palette, from, to); }), "moved skin");
}

template <class T>
static void on_mechanisms() {
  using mechanism = dq8::mechanism<T>;
  using motion = dq8::motion<T>;
  const motion bone = motion::translation_by({1, 0, 0});
  std::vector joints{mechanism::revolute(-1, {}, {0, 0, 1}), mechanism::revolute(0, bone, {0, 0, 1}), mechanism::fixed(1, bone)};
  mechanism gone(joints);
  const mechanism arm(std::move(gone));
  const std::vector<T> values{T(0.5), T(-0.25)}, many{values[0], values[1], 0, 0, 1, 1};
  const auto poses = arm.poses(values);
  const auto [x, y, z] = poses[2].translation();
  check(arm.links() == 3 && arm.values() == 2 && arm.rates() == 2, "counts");
  check(std::fabs(x - std::cos(T(0.5)) - std::cos(T(0.25))) < T(1e-5) && std::fabs(y - std::sin(T(0.5)) - std::sin(T(0.25))) < T(1e-5) && z == 0, "the tip");
  std::vector<motion> all(9), unpacked(9);
  arm.poses(many, all);
  auto blocks = dq8::blocks<T>(32 / sizeof(T), 8, 3);
  arm.poses(many, blocks);
  blocks.unpack(3, unpacked);
  check(near<T>(all[2], poses[2]) && near<T>(unpacked, all) && near<T>(arm.pose(values, 2), poses[2]), "poses of links");
  const auto [columns, pose] = arm.jacobian(values, 2);
  check(near<T>(pose, poses[2]) && near<T>(columns[0], std::array<T, 6>{0, 0, 1, -y, x, 0}), "a Jacobian");

  /* The tips of three configurations are reached again, from others. */
  std::vector<T> start{T(0.4), T(-0.2), T(0.1), T(0.2), T(0.9), T(0.8)}, one{T(0.4), T(-0.2)};
  const auto goal = mechanism::point(2);
  const std::vector<motion> targets{all[2], all[5], all[8]};
  for (const auto &report : arm.reach({goal}, targets, start)) check(report.outcome == DQ8_OUTCOME_CONVERGED, "reached");
  check(arm.reach_one({goal}, targets[0], one, mechanism::default_options(), {T(0.1), T(0.1)}).outcome == DQ8_OUTCOME_CONVERGED, "reached one");
  check(arm.pose(one, 2).distance_to(targets[0]) < T(1e-4), "the tip that was asked for");

  /* The Jacobians of two links of three configurations. */
  const std::vector<std::size_t> links{2, 1};
  std::vector<motion> some(6);
  std::vector<std::array<T, 6>> all_columns(12);
  arm.jacobians(many, links, some, all_columns, DQ8_FRAME_BODY);
  const auto last = arm.jacobian({1, 1}, 1, DQ8_FRAME_BODY);
  check(near<T>(some[5], last.pose) && near<T>(all_columns[10], last.columns[0]) && near<T>(all_columns[11], last.columns[1]), "Jacobians");
  dq8::blocks<T> pose_blocks(blocks.lanes(), 8, 2), column_blocks(blocks.lanes(), 6, 4);
  arm.jacobians(many, links, pose_blocks, column_blocks, DQ8_FRAME_BODY);
  check(std::fabs(pose_blocks.at(1, 2, 4) - some[5][4]) < T(1e-5) && std::fabs(column_blocks.at(2, 2, 4) - last.columns[0][4]) < T(1e-5), "Jacobians in blocks");
  check(refused(DQ8_STATUS_LENGTH, "columns has length 6", [&] { arm.jacobians(many, links, some, all_columns[0]); }), "columns");

  /* An arm with a spherical wrist: all solutions reach the target, and the first one is the start. */
  const motion up = motion::translation_by({0, 0, 1}), out = motion::translation_by({1, 0, 0});
  const mechanism six(std::vector{mechanism::revolute(-1, {}, {0, 0, 1}), mechanism::revolute(0, up, {0, 1, 0}), mechanism::revolute(1, up, {0, 1, 0}),
                                  mechanism::revolute(2, {}, {1, 0, 0}), mechanism::revolute(3, out, {0, 1, 0}), mechanism::revolute(4, {}, {1, 0, 0})});
  const std::array<T, 6> bent{T(0.3), T(0.4), T(0.9), T(0.2), T(0.8), T(0.1)};
  const motion target = six.pose(bent, 5);
  const auto [six_columns, six_pose] = six.jacobian(bent, 5);
  std::array<T, 6> speeds{T(0.5), T(-0.25), 1, 2, T(-0.5), T(0.75)}, twist{};
  for (std::size_t i = 0; i < 36; i++) twist[i % 6] += six_columns[i / 6][i % 6] * speeds[i / 6];
  check(near<T>(six_pose, target) && near<T>(six.rates_for(bent, 5, twist), speeds), "rates give the twist");
  auto slower = six.rates_for(bent, 5, twist, T(1));
  check(std::fabs(slower[3]) < std::fabs(speeds[3]), "damping");
  std::array<T, 36> scratch{};
  std::array<T, 6> twice{};
  six.rates_for(bent, 5, twist, scratch, twice, T(1));
  check(near<T>(twice, slower) && six.manipulability(bent, 5) > T(0.1) && six.manipulability(bent, 5, scratch) == six.manipulability(bent, 5), "manipulability");
  check(six.manipulability({T(0.3), T(0.4), T(0.9), T(0.2), 0, T(0.1)}, 5) < T(1e-5), "a wrist that is straight");
  check(refused(DQ8_STATUS_LENGTH, "found has length 3", [&] { std::vector<T> few(3); six.rates_for(bent, 5, twist, scratch, few); }), "rates");
  check(refused(DQ8_STATUS_UNKNOWN_VALUE, "rates_for", [&] { six.rates_for(bent, 5, twist, -1); }), "negative damping");
  check(refused(DQ8_STATUS_NO_LINK, "manipulability", [&] { six.manipulability(bent, 6); }), "manipulability of no link");
  const auto found = six.solutions(mechanism::whole(5), target, bent);
  check(found.size() == 1 && found[0].count >= 2 && found[0].is_complete == 1 && found[0].all[0].distance < T(1e-3), "solutions");
  for (std::size_t i = 0; i < found[0].count; i++) check(six.pose(found[0].all[i].values, 5).distance_to(target) < T(1e-4), "a solution");
  /* An arm of no family, which is searched. */
  const motion askew({T(0.1), T(0.2), 0, std::sqrt(T(0.95))}, {T(0.3), T(0.1), T(0.4)});
  std::vector<typename mechanism::joint> hinges;
  for (std::int32_t joint = 0; joint < 6; joint++) hinges.push_back(mechanism::revolute(joint - 1, askew, {0, joint % 2 == 0 ? T(0) : T(1), joint % 2 == 0 ? T(1) : T(0)}));
  const mechanism other(hinges);
  const auto searched = other.solutions(mechanism::whole(5), other.pose(bent, 5), bent);
  check(searched[0].count >= 1 && searched[0].is_complete == 0 && searched[0].all[0].distance < T(1e-2), "an arm that is searched");
  check(refused(DQ8_STATUS_LENGTH, "starts has length 3", [&] { six.solutions(mechanism::whole(5), target, {1, 2, 3}); }), "starts");
  check(refused(DQ8_STATUS_NOT_UNIT, "solutions", [&] { six.solutions(mechanism::whole(5), motion({0, 0, 0, 2, 0, 0, 0, 0}), bent); }, 0), "a target that is not unit");
  check(refused(DQ8_STATUS_NOT_SIX_HINGES, "solutions", [&] { arm.solutions(mechanism::whole(2), target, bent); }), "two hinges");

  const std::vector every{mechanism::floating(-1), mechanism::prismatic(0, bone, {1, 0, 0}), mechanism::screw(1, bone, {0, 1, 0}, T(0.5)),
                          mechanism::planar(2, bone, {0, 0, 1}), mechanism::limited(mechanism::revolute(3, {}, {1, 0, 0}), -1, 1),
                          mechanism::mimicking(mechanism::revolute(4, {}, {1, 0, 0}), 4, 2, 0)};
  check(mechanism(every).values() == 7 + 1 + 1 + 3 + 1 && mechanism(every).rates() == 6 + 1 + 1 + 3 + 1, "all kinds of joints");
  joints[1].axis[2] = 2;
  check(refused(DQ8_STATUS_AXIS, "mechanism", [&] { mechanism wrong(joints); }, 1), "an axis that is too long");
  check(refused(DQ8_STATUS_NO_LINK, "pose", [&] { arm.pose(values, 3); }), "no such link");
  check(refused(DQ8_STATUS_LENGTH, "values has length 3", [&] { arm.poses({1, 2, 3}); }), "values");
  check(refused(DQ8_STATUS_LENGTH, "poses has length 72", [&] { arm.poses(values, all); }), "poses");
  check(refused(DQ8_STATUS_LENGTH, "targets has length 8", [&] { arm.reach({goal}, targets[0], start); }), "targets");
  check(refused(DQ8_STATUS_LENGTH, "posture has length 1", [&] { arm.reach({goal}, targets, start, mechanism::default_options(), {T(1)}); }), "posture");
  check(refused(DQ8_STATUS_WEIGHT, "reach", [&] { arm.reach({}, dq8::span<const T>(), start); }), "no goal");
  check(refused(DQ8_STATUS_UNKNOWN_VALUE, "mechanism: this object has been moved away", [&] { gone.pose(values, 1); }), "moved mechanism");
}

template <class T>
static void over_time() {
  using motion = dq8::motion<T>;
  using pose = dq8::motion<double>;
  const std::vector<double> stamps{0, 2}, times{1};
  const std::vector<pose> poses{pose(), pose::translation_by({2, 0, 0})};
  const dq8::trajectory path(stamps, poses);
  std::vector<motion> at(1);
  std::vector<std::array<T, 6>> twists(1), accelerations(1);
  path.sample(times, at, twists);
  check(near<T>(at[0].translation(), std::array<T, 3>{1, 0, 0}) && near<T>(twists, std::array<T, 6>{0, 0, 0, 1, 0, 0}), "between two poses");
  const std::vector<T> points{1, 2, 3};
  std::vector<T> moved(3), back(3);
  path.deskew({3e9}, points, moved, dq8::trajectory_options().clock(0, 1e-9).continues());
  check(near<T>(moved, std::array<T, 3>{4, 2, 3}), "nanoseconds, after the end");
  path.deskew(times, points, moved, dq8::trajectory_options().in_end()), path.skew(times, moved, back, dq8::trajectory_options().in_end());
  check(near<T>(moved, std::array<T, 3>{0, 2, 3}) && near<T>(back, points), "deskew and skew");
  const std::vector<pose> control{pose(), pose::translation_by({1, 0, 0}), pose::translation_by({2, 0, 0}), pose::translation_by({3, 0, 0})};
  const dq8::spline curve(0, 1, control, dq8::spline::basis::through);
  curve.sample({0.5}, at, twists, accelerations);
  check(near<T>(at[0].translation(), std::array<T, 3>{T(1.5), 0, 0}) && near<T>(twists, std::array<T, 6>{0, 0, 0, 1, 0, 0}), "a spline");
  const std::vector<T> known{0, 2}, when{1};
  const std::vector<motion> some{motion(), motion::translation_by({2, 0, 0})};
  dq8::resample(known, some, when, at);
  check(near<T>(at[0].translation(), std::array<T, 3>{1, 0, 0}), "resampled");

  check(refused(DQ8_STATUS_TIMES, "trajectory", [&] { dq8::trajectory({1, 1}, poses); }, 1), "stamps");
  check(refused(DQ8_STATUS_OUTSIDE, "sample", [&] { path.sample({1, 5}, std::vector<motion>(2), {}, dq8::trajectory_options().refuses()); }, 1), "outside");
  check(refused(DQ8_STATUS_LENGTH, "points has length 3", [&] { path.deskew({1, 2}, points, moved); }), "points");
  check(refused(DQ8_STATUS_LENGTH, "twists has length 12", [&] { path.sample(times, at, std::vector<T>(12)); }), "twists");
  check(refused(DQ8_STATUS_LENGTH, "poses has length 16", [&] { dq8::resample({0}, some, when, at); }), "poses of resample");
  check(refused(DQ8_STATUS_FEW_POSES, "spline", [&] { dq8::spline(0, 1, poses); }), "too few control poses");
}

template <class T>
static void on_clips() {
  using motion = dq8::motion<T>;
  const dq8::skeleton skeleton({-1, 0});
  /* The first joint slides from 0 to 2 in two seconds, and the second one is one unit beside it. */
  std::vector<std::array<float, 7>> keys;
  for (int frame = 0; frame < 3; frame++) keys.push_back({0, 0, 0, 1, float(frame), 0, 0}), keys.push_back({0, 0, 0, 1, 0, 1, 0});
  dq8::clips gone = dq8::clips::pack(2, {{keys, 1, false}, {keys, 0.5, true}});
  const dq8::clips clips(std::move(gone));
  check(clips.joints() == 2 && clips.size() == 2 && clips.duration(0) == 2 && clips.duration(1) == 4, "clips");
  std::vector<motion> models(2), both(4);
  clips.play(skeleton, 0, T(0.5), models, motion::translation_by({0, 0, 3}));
  check(near<T>(models[1].translation(), std::array<T, 3>{T(0.5), 1, 3}), "a clip");
  const auto [first, at] = clips.template place<T>(0, T(1.25));
  const auto [second, later] = clips.template place<T>(1, T(1));
  const std::vector<dq8_place> places{first, second};
  clips.to_model(skeleton, places, {at, later}, both);
  check(near<T>(both[0].translation(), std::array<T, 3>{T(1.25), 0, 0}) && near<T>(both[3].translation(), std::array<T, 3>{T(0.5), 1, 0}), "two places");
  check(clips.bytes().size() == 208, "no byte of the bound is left");
  const dq8::clips read(std::vector<std::uint8_t>(clips.bytes().begin(), clips.bytes().end()));
  check(read.size() == 2, "the bytes of a file");

  check(refused(DQ8_STATUS_NOT_CLIPS, "clips", [] { dq8::clips({1, 2, 3}); }, 0), "no clips");
  check(refused(DQ8_STATUS_NOT_FINITE, "clips::place", [&] { clips.template place<T>(0, std::numeric_limits<T>::quiet_NaN()); }), "no time");
  check(refused(DQ8_STATUS_LENGTH, "t has length 1", [&] { clips.to_model(skeleton, places, {at}, both); }), "t");
  check(refused(DQ8_STATUS_LENGTH, "the skeleton has length 1", [&] { clips.to_model(dq8::skeleton({-1}), places, {at, later}, both); }), "another skeleton");
  check(refused(DQ8_STATUS_LENGTH, "keys has length 42", [&] { dq8::clips::pack(4, {{keys}}); }), "keys");
  keys[4][3] = 2;
  check(refused(DQ8_STATUS_NOT_UNIT, "clips::pack", [&] { dq8::clips::pack(2, {{keys}}); }, 4), "a key that is not unit");
  check(refused(DQ8_STATUS_UNKNOWN_VALUE, "clips: this object", [&] { gone.duration(0); }), "moved clips");
}

template <class T>
static void on_files() {
  const dq8::urdf<T> door("<robot name='door'><link name='wall'/><link name='door'/><joint name='hinge' type='revolute'><parent link='wall'/>"
                          "<child link='door'/><origin xyz='1 0 0'/><axis xyz='0 0 1'/><limit upper='2' velocity='1' effort='1'/></joint></robot>");
  const dq8::mechanism<T> robot(door.joints);
  check(door.links == std::vector<std::string>{"wall", "door"} && door.values == std::vector<std::string>{"hinge"}, "names");
  check(near<T>(robot.pose({T(0.5)}, door.link("door")).point({0, 0, 0}), std::array<T, 3>{1, 0, 0}), "a robot from a file");
  check(refused(DQ8_STATUS_NO_LINK, "window", [&] { door.link("window"); }), "no window");
  check(refused(DQ8_STATUS_URDF, "line 1", [] { dq8::urdf<T>("<robot"); }), "no file");
}

template <class T>
static void all() {
  on_clips<T>();
  on_files<T>();
  on_arrays<T>();
  on_motions<T>();
  on_skeletons<T>();
  on_meshes<T>();
  on_mechanisms<T>();
  over_time<T>();
}

int main() {
  all<float>();
  all<double>();
  check(dq8::backend_name() != nullptr, "the name of the backend");
  dq8::backend_limit(DQ8_BACKEND_ANY), dq8::set_reproducible(false);
  check(refused(DQ8_STATUS_UNKNOWN_VALUE, "backend_limit", [] { dq8::backend_limit(99); }), "no backend");
  std::puts(failures == 0 ? "PASS" : "FAIL");
  return failures;
}
