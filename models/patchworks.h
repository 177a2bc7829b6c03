/// \file
/// The shapes that several patches cover.
#pragma once

#include <foldless/models/place.h>
#include <foldless/models/quilt.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// Patches and the surface over them.
struct Patchwork {
    std::vector<QuiltPatch> patches;
    Surface surface;
};

/// The unit sphere, from a cube whose lines are spaced by equal angles: cells differ in area by less than 1.5 : 1.
[[nodiscard]] Patchwork sphere();

/// A sphere whose radius varies by at most a third with the direction, as a sum of sinusoids: star-shaped.
[[nodiscard]] Patchwork bumpy_sphere();

/// Two tori with a straight neck between windows in their outer sides: a smooth surface of genus 2 but for the two
/// creases at the ends of the neck.
[[nodiscard]] Patchwork genus2();

/// A tube about the z axis, open at both ends, with four rectangular holes.
[[nodiscard]] Patchwork cylinder();

/// A box with two bent flaps, 0.04 thick, 0.6 wide and 0.8 high, on its top.
[[nodiscard]] Patchwork ears();

/// Four boxes around the corner `spike_corner`, leaning such that no direction sees all the faces at that corner.
[[nodiscard]] Patchwork spike();

/// The corner of spike(), and as corners come first, its vertex at any size.
constexpr std::int32_t spike_corner = 12;

/// A cube with edges of n, whose vertices lie at whole numbers, so that lengths, areas and angles tie exactly.
[[nodiscard]] Patchwork cube(std::int64_t n);

} // namespace foldless
