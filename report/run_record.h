/// \file
/// What a run did: everything that its report and its summary tell.
#pragma once

#include <foldless/bake/atlas_maps.h>
#include <foldless/bake/fit_maps.h>
#include <foldless/bake/surface_distance.h>
#include <foldless/decimate/decimate.h>
#include <foldless/io/defects.h>
#include <foldless/io/read_mesh.h>
#include <foldless/repair/repair.h>
#include <foldless/report/displacement.h>
#include <foldless/report/phase_times.h>
#include <foldless/report/preset.h>
#include <foldless/verify/verify.h>

#include <cstddef>
#include <optional>
#include <string>

namespace foldless {

/// A mesh that was read.
struct InputRecord {
    std::string path;
    std::size_t vertices = 0;
    std::size_t faces = 0;
    Topology topology;
};

/// A base mesh.
struct OutputRecord {
    std::string path; ///< empty if it was not written
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::size_t frozen_faces = 0;
};

/// What the run took.
struct Usage {
    PhaseTimes times;
    std::size_t peak_memory_bytes = 0;
    int threads = 1;
};

/// A run of `foldless simplify`.
struct SimplifyRecord {
    Preset preset = Preset::standard;
    DecimateOptions options;
    InputRecord input;
    OutputRecord output;
    StopReason stop_reason = StopReason::every_edge_refused;
    DecimateStatistics statistics;
    DisplacementStatistics displacement;
    std::optional<VerifyResult> certificate; ///< no value: not verified
    Usage usage;
};

/// A run of `foldless verify`.
struct VerifyRecord {
    InputRecord input;
    OutputRecord output;
    DisplacementStatistics displacement;
    VerifyResult certificate;
    Usage usage;
};

/// A run of `foldless repair`.
struct RepairRecord {
    RepairOptions options;
    InputRecord input; ///< without topology: a mesh with defects has none
    Defects defects;   ///< of the input
    RepairCounts counts;
    InputRecord output; ///< as it will be read
    Usage usage;
};

/// The files that `foldless bake` wrote.
struct MapsRecord {
    std::string path; ///< the folder; empty if nothing was written
    BakeMethod method = BakeMethod::inverse;
    int size = 0; ///< texels on a side
    std::size_t samples = 0;
    std::size_t uncovered = 0; ///< samples
    std::size_t contested = 0; ///< samples
};

/// The search for maps that fit a bound on the error.
struct FitRecord {
    double max_error = 0.0; ///< model units: what was asked for
    double diagonal = 0.0;  ///< of the scan, model units
    MapFit fit;
};

/// A run of `foldless bake`.
struct BakeRecord {
    InputRecord input;
    OutputRecord base;
    MapsRecord maps;
    std::optional<FitRecord> fit;
    VerifyResult certificate;
    Usage usage;
};

/// How far a surface is from the scan that it should be.
struct Comparison {
    InputRecord scan;
    double diagonal = 0.0; ///< of the scan, model units
    double bound = 0.0;    ///< to which the maxima are known, model units
    SurfaceDistance distance;
};

/// A run of `foldless reconstruct`.
struct ReconstructRecord {
    std::string base;
    std::string maps;
    int level = 0;
    std::string path; ///< of what was written
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::optional<Comparison> comparison;
    Usage usage;
};

/// What `foldless repair` would make of a mesh.
struct RepairOutlook {
    std::size_t vertices = 0;
    std::size_t faces = 0;
    RepairCounts counts;
};

/// The answer of `foldless info`.
struct InfoRecord {
    enum class DirectionsFound { none, vertices, faces };

    std::string path;
    std::size_t vertices = 0;
    std::size_t faces = 0;
    bool float32 = true;
    double diagonal = 0.0; ///< of the bounding box of the vertices that faces use, model units
    Inspection inspection;
    ReadNotes notes;
    std::string refusal;                 ///< why `simplify` would refuse the mesh; empty if it would not
    std::optional<RepairOutlook> repair; ///< what would make a refused mesh acceptable; no value: no repair would
    DirectionsFound directions = DirectionsFound::none;
    bool has_ranges = false;
};

/// 1 - faces out / faces in; 0 without faces.
[[nodiscard]] double decimation_rate(const InputRecord& input, const OutputRecord& output);

} // namespace foldless
