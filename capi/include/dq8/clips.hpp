/* Packed clips: animations of a skeleton in a quarter of the memory. */
#ifndef DQ8_CLIPS_HPP
#define DQ8_CLIPS_HPP

#include "hierarchy.hpp"

namespace dq8 {

/* The frames of a clip: local poses [frame][joint] of seven numbers each, a unit quaternion (x, y, z, w) and a translation.
   `rate` is in frames a second, so that times are in seconds, or 0 for times in frames. */
struct clip_frames {
  span<const float> keys;
  double rate = 0;
  bool loops = false;
};

/* Packed clips of one skeleton, which own the bytes of their file. They can be moved but not copied. Clips that have been moved
   away throw. */
class clips {
 public:
  /* Takes the bytes of a file. Throws an error whose index is the offset of the first wrong byte. */
  explicit clips(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {
    std::size_t bad = nowhere;
    const dq8_status status = dq8_clips_make(bytes_.data(), bytes_.size(), made_.fill(), &bad);
    detail::check("clips", status, bad);
  }
  /* Packs clips of a skeleton. Rotations of a joint in a clip that are all within `angle` radians of the first are kept as the
     first alone, and translations that are all within `length` of the first along each axis likewise. Throws an error whose
     index is the wrong local pose, counted through all clips. */
  static clips pack(std::size_t joints, span<const clip_frames> frames, float angle = 2e-5f, float length = 1e-5f) {
    std::vector<dq8_frames> all;
    for (const clip_frames &clip : frames) {
      const std::size_t count = detail::things("clips::pack", "keys", clip.keys.size(), 7 * joints);
      all.push_back({clip.keys.data(), count, clip.rate, clip.loops ? 1u : 0u});
    }
    std::size_t size = 0, bad = nowhere;
    dq8_status status = dq8_clips_bound(all.data(), all.size(), joints, &size, &bad);
    detail::check("clips::pack", status, bad);
    std::vector<std::uint8_t> bytes(size);
    status = dq8_clips_pack(all.data(), all.size(), joints, angle, length, bytes.data(), bytes.size(), &size, &bad);
    detail::check("clips::pack", status, bad);
    bytes.resize(size);
    bytes.shrink_to_fit();
    return clips(std::move(bytes));
  }

  std::size_t joints() const { return made_.get("clips")->joints; }
  /* The number of clips. */
  std::size_t size() const { return made_.get("clips")->clips; }
  /* The bytes of the file. */
  span<const std::uint8_t> bytes() const { return made_.get("clips"), span<const std::uint8_t>(bytes_); }
  /* Returns the time from the first to the last frame of a clip: in seconds if the clip has a rate, and in frames otherwise. */
  double duration(std::size_t clip) const {
    double duration = 0;
    detail::check("clips::duration", dq8_clips_duration(made_.get("clips"), clip, &duration));
    return duration;
  }
  /* Finds a time in a clip. Returns the frame before it, and the fraction of the way to the next frame. */
  template <class T>
  std::pair<dq8_place, T> place(std::size_t clip, T at) const {
    std::pair<dq8_place, T> place{};
    detail::check("clips::place", detail::abi<T>::clips_place(made_.get("clips"), clip, at, &place.first, &place.second));
    return place;
  }
  /* Computes the model poses, [instance][joint], of instances at these places and fractions. */
  template <class Out>
  void to_model(const skeleton &skeleton, span<const dq8_place> places, detail::in<Out> t, Out &&models,
                detail::in<Out> root = {}) const {
    constexpr auto name = "clips::to_model";
    const span<detail::number<Out>> to(models);
    const span<const std::int32_t> parents = skeleton.parents();
    detail::length(name, "the skeleton", parents.size(), joints());
    detail::length(name, "t", t.size(), places.size()), detail::length_if(name, "root", root.size(), 8);
    detail::length(name, "models", to.size(), 8 * places.size() * parents.size());
    detail::check(name, detail::abi<detail::number<Out>>::clips_to_model(parents.data(), parents.size(), detail::maybe(root),
                                                                         made_.get("clips"), places.data(), t.data(),
                                                                         places.size(), to.data()));
  }
  /* Computes the model poses of one instance at a time of a clip. */
  template <class Out>
  void play(const skeleton &skeleton, std::size_t clip, detail::number<Out> at, Out &&models,
            detail::in<Out> root = {}) const {
    const auto [where, t] = place(clip, at);
    to_model(skeleton, {&where, 1}, {&t, 1}, models, root);
  }

 private:
  std::vector<std::uint8_t> bytes_;
  detail::made<dq8_clips> made_;
};

} // namespace dq8

#endif
