/* Skeletons: joints on each other, one instance or many. */
#ifndef DQ8_HIERARCHY_HPP
#define DQ8_HIERARCHY_HPP

#include "blocks.hpp"

namespace dq8 {

/* The parents of the joints of a skeleton: each stands before its children, and -1 is none. Arrays are [instance][joint], and
   blocks [block of instances][joint]. `root` is a motion that moves all joints without a parent, if it is given. It can be
   moved but not copied. A skeleton that has been moved away throws. */
class skeleton {
 public:
  /* Copies the parents. Throws an error whose index is the wrong joint. */
  explicit skeleton(span<const std::int32_t> parents) : parents_(parents.begin(), parents.end()) {
    std::size_t bad = nowhere;
    const dq8_status status = dq8_check_parents(parents_.data(), parents_.size(), &bad);
    detail::check("skeleton", status, bad);
  }

  /* Returns the parents. */
  span<const std::int32_t> parents() const { return owner_.check("skeleton"), span<const std::int32_t>(parents_); }
  std::size_t joints() const { return parents().size(); }

  /* Computes model poses from local poses. `models` may be `locals`. */
  template <class Out>
  void local_to_model(detail::in<Out> locals, Out &&models, detail::in<Out> root = {}) const {
    plain("skeleton::local_to_model", of<Out>::local_to_model, "locals", locals, 8, models, root);
  }
  template <class T>
  void local_to_model(const blocks<T> &locals, blocks<T> &models, span<const detail::same<T>> root = {}) const {
    lanes("skeleton::local_to_model", detail::abi<T>::blocks_local_to_model, "locals", locals, 8, models, root);
  }
  /* Computes local poses from model poses. `locals` may be `models`. */
  template <class Out>
  void model_to_local(detail::in<Out> models, Out &&locals, detail::in<Out> root = {}) const {
    plain("skeleton::model_to_local", of<Out>::model_to_local, "models", models, 8, locals, root);
  }
  template <class T>
  void model_to_local(const blocks<T> &models, blocks<T> &locals, span<const detail::same<T>> root = {}) const {
    lanes("skeleton::model_to_local", detail::abi<T>::blocks_model_to_local, "models", models, 8, locals, root);
  }
  /* Computes model poses from unit quaternions (x, y, z, w), and the offset of each joint in its parent. */
  template <class Out>
  void rotations_to_model(detail::in<Out> rotations, detail::in<Out> offsets, Out &&models, detail::in<Out> root = {}) const {
    constexpr auto name = "skeleton::rotations_to_model";
    detail::length(name, "offsets", offsets.size(), 3 * joints());
    plain(name, of<Out>::rotations_to_model, "rotations", rotations, 4, models, root, offsets.data());
  }
  template <class T>
  void rotations_to_model(const blocks<T> &rotations, span<const detail::same<T>> offsets, blocks<T> &models,
                          span<const detail::same<T>> root = {}) const {
    constexpr auto name = "skeleton::rotations_to_model";
    detail::length(name, "offsets", offsets.size(), 3 * joints());
    lanes(name, detail::abi<T>::blocks_rotations_to_model, "rotations", rotations, 4, models, root, offsets.data());
  }
  /* Computes model poses from local poses of seven numbers: a unit quaternion (x, y, z, w) and a translation. */
  template <class Out>
  void rotations_translations_to_model(detail::in<Out> locals, Out &&models, detail::in<Out> root = {}) const {
    plain("skeleton::rotations_translations_to_model", of<Out>::rotations_translations_to_model, "locals", locals, 7, models,
          root);
  }
  template <class T>
  void rotations_translations_to_model(const blocks<T> &locals, blocks<T> &models,
                                       span<const detail::same<T>> root = {}) const {
    lanes("skeleton::rotations_translations_to_model", detail::abi<T>::blocks_rotations_translations_to_model, "locals",
          locals, 7, models, root);
  }
  /* Computes model poses, and the palette that moves a mesh at rest: models[j] * inverse_binds[j]. */
  template <class Out>
  void palette(detail::in<Out> locals, detail::in<Out> inverse_binds, Out &&models, span<detail::number<Out>> palette,
               detail::in<Out> root = {}) const {
    palettes("skeleton::palette", of<Out>::palette, 8, locals, inverse_binds, span<detail::number<Out>>(models), palette,
             root);
  }
  template <class T>
  void palette(const blocks<T> &locals, span<const detail::same<T>> inverse_binds, blocks<T> &models, blocks<T> &palette,
               span<const detail::same<T>> root = {}) const {
    palettes_in_blocks("skeleton::palette", detail::abi<T>::blocks_palette, 8, locals, inverse_binds, models, palette, root);
  }
  /* Computes model poses, and the palette as matrices [R | t] of twelve numbers, row by row. */
  template <class Out>
  void palette_matrices(detail::in<Out> locals, detail::in<Out> inverse_binds, Out &&models,
                        span<detail::number<Out>> palette, detail::in<Out> root = {}) const {
    palettes("skeleton::palette_matrices", of<Out>::palette_matrices, 12, locals, inverse_binds,
             span<detail::number<Out>>(models), palette, root);
  }
  template <class T>
  void palette_matrices(const blocks<T> &locals, span<const detail::same<T>> inverse_binds, blocks<T> &models,
                        blocks<T> &palette, span<const detail::same<T>> root = {}) const {
    palettes_in_blocks("skeleton::palette_matrices", detail::abi<T>::blocks_palette_matrices, 12, locals, inverse_binds,
                       models, palette, root);
  }

 private:
  template <class Out>
  using of = detail::abi<detail::number<Out>>;

  template <class Function, class T, class Out, class... More>
  void plain(const char *name, Function function, const char *argument, span<const T> from, std::size_t each, Out &out,
             span<const T> root, More... more) const {
    const span<T> to(out);
    const std::size_t count = joints() * detail::things(name, "the output", to.size(), 8 * joints());
    detail::length(name, argument, from.size(), each * count), detail::length_if(name, "root", root.size(), 8);
    detail::check(name, function(parents_.data(), joints(), detail::maybe(root), from.data(), more..., to.data(), count));
  }
  template <class Function, class T, class... More>
  void lanes(const char *name, Function function, const char *argument, const blocks<T> &from, std::size_t each,
             blocks<T> &out, span<const T> root, More... more) const {
    from.beside(out, each, name, argument), detail::length_if(name, "root", root.size(), 8);
    detail::things(name, "the output, in blocks,", out.count(), joints());
    detail::check(name, function(out.has(8, name), parents_.data(), joints(), detail::maybe(root), from.numbers().data(),
                                 more..., out.numbers().data(), out.count()));
  }
  template <class Function, class T>
  void palettes(const char *name, Function function, std::size_t each, span<const T> locals, span<const T> binds,
                span<T> models, span<T> palette, span<const T> root) const {
    const std::size_t count = joints() * detail::things(name, "models", models.size(), 8 * joints());
    detail::length(name, "locals", locals.size(), 8 * count), detail::length(name, "palette", palette.size(), each * count);
    detail::length(name, "inverse_binds", binds.size(), 8 * joints()), detail::length_if(name, "root", root.size(), 8);
    detail::check(name, function(parents_.data(), joints(), detail::maybe(root), locals.data(), binds.data(), models.data(),
                                 palette.data(), count));
  }
  template <class Function, class T>
  void palettes_in_blocks(const char *name, Function function, std::size_t each, const blocks<T> &locals,
                          span<const T> binds, blocks<T> &models, blocks<T> &palette, span<const T> root) const {
    locals.beside(models, 8, name, "locals"), palette.beside(models, each, name, "palette");
    detail::length(name, "inverse_binds", binds.size(), 8 * joints()), detail::length_if(name, "root", root.size(), 8);
    detail::things(name, "models, in blocks,", models.count(), joints());
    detail::check(name, function(models.has(8, name), parents_.data(), joints(), detail::maybe(root),
                                 locals.numbers().data(), binds.data(), models.numbers().data(), palette.numbers().data(),
                                 models.count()));
  }

  std::vector<std::int32_t> parents_;
  detail::owner owner_;
};

/* The fastest order of the joints of a skeleton for one instance. */
class plan {
 public:
  explicit plan(const skeleton &skeleton) : plan(skeleton.parents()) {}
  explicit plan(span<const std::int32_t> parents)
      : parents_(parents.begin(), parents.end()), order_(2 * parents.size()) {
    std::vector<std::uint32_t> scratch(6 * parents.size());
    std::size_t bad = nowhere;
    const dq8_status status = dq8_plan_make(parents_.data(), parents_.size(), order_.data(), scratch.data(), &bad);
    detail::check("plan", status, bad);
  }
  /* Computes model poses from local poses, [instance][joint]. `models` may be `locals`. */
  template <class Out>
  void local_to_model(detail::in<Out> locals, Out &&models) const {
    using T = detail::number<Out>;
    constexpr auto name = "plan::local_to_model";
    owner_.check("plan");
    const span<T> to(models);
    const std::size_t joints = parents_.size(), count = joints * detail::things(name, "models", to.size(), 8 * joints);
    detail::length(name, "locals", locals.size(), to.size());
    detail::check(name, detail::abi<T>::plan_local_to_model(parents_.data(), order_.data(), joints, locals.data(), to.data(),
                                                            count));
  }

 private:
  std::vector<std::int32_t> parents_;
  std::vector<std::uint32_t> order_;
  detail::owner owner_;
};

} // namespace dq8

#endif
