/* Meshes that follow joints. */
#ifndef DQ8_SKIN_HPP
#define DQ8_SKIN_HPP

#include "abi.hpp"

namespace dq8 {

/* A mesh as arrays: positions, and normals and tangents if it has them, three numbers for each vertex. */
template <class T>
struct surface {
  span<T> positions, normals = {}, tangents = {};
};
/* A mesh as a buffer of whole vertices, and where the fields of a vertex are, counted in numbers. */
template <class T>
struct vertex_buffer {
  span<T> numbers;
  dq8_vertex_fields fields;
  vertex_buffer(span<T> all, dq8_vertex_fields of_each) : numbers(all), fields(of_each) {}
};

/* The joints and weights of the vertices of a mesh. It owns its memory, and can be moved but not copied. A skin that has been
   moved away throws. */
template <class T>
class skin {
  using abi = detail::abi<T>;

 public:
  using rest = surface<const T>;
  using rest_buffer = vertex_buffer<const T>;

  /* Takes arrays [vertex][influence], `influences` for each vertex. Throws an error whose index is the wrong vertex. */
  skin(std::size_t joint_count, std::size_t influences, std::vector<std::uint16_t> joints, std::vector<T> weights)
      : joints_(std::move(joints)), weights_(std::move(weights)) {
    detail::length("skin", "weights", weights_.size(), joints_.size());
    if (influences == 0) detail::check("skin", DQ8_STATUS_NO_INFLUENCES);
    const std::size_t vertices = detail::things("skin", "joints", joints_.size(), influences);
    std::size_t bad = nowhere;
    const dq8_status status =
        abi::skin_make(joint_count, influences, joints_.data(), weights_.data(), vertices, made_.fill(), &bad);
    detail::check("skin", status, bad);
  }
  /* Takes buffers of whole vertices, and where joints and weights of a vertex are, counted in elements. */
  skin(std::size_t joint_count, std::size_t influences, std::vector<std::uint16_t> joints, dq8_influence_field joint_field,
       std::vector<T> weights, dq8_influence_field weight_field)
      : joints_(std::move(joints)), weights_(std::move(weights)) {
    const std::size_t vertices = detail::things("skin", "joints", joints_.size(), joint_field.stride);
    detail::length("skin", "weights", weights_.size(), vertices * weight_field.stride);
    std::size_t bad = nowhere;
    const dq8_status status = abi::skin_make_interleaved(joint_count, influences, joints_.data(), joint_field,
                                                         weights_.data(), weight_field, vertices, made_.fill(), &bad);
    detail::check("skin", status, bad);
  }

  std::size_t vertices() const { return made_.get("skin")->vertices; }
  std::size_t joints() const { return made_.get("skin")->joints; }

  /* Poses a mesh by linear blends of matrices, twelve numbers for each joint, row by row. */
  void linear(span<const T> matrices, const rest &from, const surface<T> &to) const {
    palette("skin::linear", "matrices", matrices, 12);
    pose("skin::linear", abi::skin_linear, from, to, matrices.data());
  }
  void linear(span<const T> matrices, const rest_buffer &from, const vertex_buffer<T> &to) const {
    palette("skin::linear", "matrices", matrices, 12);
    pose("skin::linear", abi::skin_linear_interleaved, from, to, matrices.data());
  }
  /* Poses a mesh by dual quaternion blends of motions, such as those of skeleton::palette. */
  void dual(span<const T> motions, const rest &from, const surface<T> &to) const {
    palette("skin::dual", "motions", motions, 8);
    pose("skin::dual", abi::skin_dual, from, to, motions.data());
  }
  void dual(span<const T> motions, const rest_buffer &from, const vertex_buffer<T> &to) const {
    palette("skin::dual", "motions", motions, 8);
    pose("skin::dual", abi::skin_dual_interleaved, from, to, motions.data());
  }
  /* Poses a mesh whose joints scale or shear, by the motions and stretches of skin_split. */
  void stretched(span<const T> motions, span<const T> stretches, const rest &from, const surface<T> &to) const {
    palette("skin::stretched", "motions", motions, 8), palette("skin::stretched", "stretches", stretches, 12);
    pose("skin::stretched", abi::skin_stretched, from, to, motions.data(), stretches.data());
  }
  void stretched(span<const T> motions, span<const T> stretches, const rest_buffer &from, const vertex_buffer<T> &to) const {
    palette("skin::stretched", "motions", motions, 8), palette("skin::stretched", "stretches", stretches, 12);
    pose("skin::stretched", abi::skin_stretched_interleaved, from, to, motions.data(), stretches.data());
  }
  /* Poses a mesh by a mix of both blends: `shares` has how much of the dual one each vertex gets, from 0 to 1. */
  void mixed(span<const T> matrices, span<const T> motions, span<const T> shares, const rest &from,
             const surface<T> &to) const {
    mix(matrices, motions, shares);
    pose("skin::mixed", abi::skin_mixed, from, to, matrices.data(), motions.data(), shares.data());
  }
  void mixed(span<const T> matrices, span<const T> motions, span<const T> shares, const rest_buffer &from,
             const vertex_buffer<T> &to) const {
    mix(matrices, motions, shares);
    pose("skin::mixed", abi::skin_mixed_interleaved, from, to, matrices.data(), motions.data(), shares.data());
  }

 private:
  void palette(const char *name, const char *argument, span<const T> palette, std::size_t each) const {
    detail::length(name, argument, palette.size(), each * joints());
  }
  void mix(span<const T> matrices, span<const T> motions, span<const T> shares) const {
    palette("skin::mixed", "matrices", matrices, 12), palette("skin::mixed", "motions", motions, 8);
    detail::length("skin::mixed", "shares", shares.size(), vertices());
  }
  template <class Function, class... Palettes>
  void pose(const char *name, Function function, const rest &from, const surface<T> &to, Palettes... palettes) const {
    const std::size_t numbers = 3 * vertices();
    detail::length(name, "the positions at rest", from.positions.size(), numbers);
    detail::length(name, "the posed positions", to.positions.size(), numbers);
    detail::length_if(name, "the normals at rest", from.normals.size(), numbers);
    detail::length(name, "the posed normals", to.normals.size(), from.normals.size());
    detail::length_if(name, "the tangents at rest", from.tangents.size(), numbers);
    detail::length(name, "the posed tangents", to.tangents.size(), from.tangents.size());
    detail::check(name, function(made_.get("skin"), palettes..., joints(), from.positions.data(), detail::maybe(from.normals),
                                 detail::maybe(from.tangents), to.positions.data(), detail::maybe(to.normals),
                                 detail::maybe(to.tangents), vertices()));
  }
  template <class Function, class... Palettes>
  void pose(const char *name, Function function, const rest_buffer &from, const vertex_buffer<T> &to,
            Palettes... palettes) const {
    detail::length(name, "the buffer at rest", from.numbers.size(), vertices() * from.fields.stride);
    detail::length(name, "the posed buffer", to.numbers.size(), vertices() * to.fields.stride);
    detail::check(name, function(made_.get("skin"), palettes..., joints(), from.numbers.data(), from.fields,
                                 to.numbers.data(), to.fields, vertices()));
  }

  std::vector<std::uint16_t> joints_;
  std::vector<T> weights_;
  detail::made<typename abi::skin> made_;
};

/* Computes a palette of matrices, models[j] * inverse_binds[j], from the 4x4 matrices of an engine, in `order`, one of enum
   dq8_matrix_order. The palette has twelve numbers for each joint, row by row. */
template <class Out>
void skin_products(detail::in<Out> models, detail::in<Out> inverse_binds, std::int32_t order, Out &&matrices) {
  const span<detail::number<Out>> to(matrices);
  const std::size_t joints = detail::things("skin_products", "matrices", to.size(), 12);
  detail::length("skin_products", "models", models.size(), 16 * joints);
  detail::length("skin_products", "inverse_binds", inverse_binds.size(), 16 * joints);
  detail::check("skin_products", detail::abi<detail::number<Out>>::skin_products(models.data(), inverse_binds.data(), order,
                                                                                 to.data(), joints));
}

/* Splits the matrices of a palette into motions and stretches, of which the stretch acts first: palettes of skin::stretched. */
template <class Out>
void skin_split(detail::in<Out> matrices, Out &&motions, span<detail::number<Out>> stretches) {
  const span<detail::number<Out>> to(motions);
  const std::size_t joints = detail::things("skin_split", "motions", to.size(), 8);
  detail::length("skin_split", "matrices", matrices.size(), 12 * joints);
  detail::length("skin_split", "stretches", stretches.size(), 12 * joints);
  detail::check("skin_split",
                detail::abi<detail::number<Out>>::skin_split(matrices.data(), to.data(), stretches.data(), joints));
}

} // namespace dq8

#endif
