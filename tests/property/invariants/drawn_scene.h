// SPDX-License-Identifier: MIT
// Random scenes, starts and tilts, and their images under symmetries.
#pragma once

#include "support/experiment.h"
#include "support/random.h"

#include <array>
#include <vector>

namespace invariants {

/// The inputs of a run.
struct Drawn {
    support::SceneBuilder scene;
    phys_params params;
    phys_state start;
    std::vector<phys_vec3> gravities; ///< each holds for kSegment steps
    double dt;
};

inline constexpr int kSegment = 64;
inline constexpr int kSegments = 8;

/// A room of 4 m with boxes in the cells of a lattice, at least two ball diameters apart, a start clear of them, and
/// parameters of all magnitudes. Coordinates are short binary numbers.
Drawn draw(support::Random &random, uint32_t model);
/// The same with floors and walls of single cells of the lattice: flush with one another, and most of them parts of no
/// box.
Drawn drawTiles(support::Random &random, uint32_t model);

/// A change of the frame or the units that is exact in floating point.
struct Change {
    const char *name;
    /// (x, y) -> (xx x + xy y, yx x + yy y); entries 0, 1 or -1.
    double xx, xy, yx, yy;
    double length, time; ///< factors, powers of two
};

/// The reflections, rotations and scalings of model.md 9.
extern const std::array<Change, 6> kChanges;

Drawn changed(const Drawn &drawn, const Change &change);
phys_state changed(const phys_state &state, const Change &change);

/// The same boxes, with those inside the room cut into flush pieces along x or y.
Drawn cutIntoPieces(const Drawn &drawn, support::Random &random, int pieces);
/// The same boxes in another order.
Drawn shuffled(const Drawn &drawn, support::Random &random);

/// The experiment that a drawn scene describes, at its start.
support::Experiment makeExperiment(const Drawn &drawn, const QByteArray &stepper);

/// Equal numbers: 0 and -0 are the same.
bool sameMotion(const phys_state &a, const phys_state &b);

} // namespace invariants
