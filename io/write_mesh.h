/// \file
/// Writing base meshes, correspondences and reports, whole or not at all.
#pragma once

#include <foldless/io/atomic_file.h>
#include <foldless/io/base_mesh.h>
#include <foldless/io/errors.h>
#include <foldless/io/scan.h>

#include <filesystem>
#include <string>
#include <vector>

namespace foldless {

/// Finds out early what would stop stage_correspondence or stage_text later: a folder that does not exist or may not be
/// written, a target that is no file. Leaves no trace.
///
/// \throws UnwritableFile
void require_writable(const std::filesystem::path& path);

/// As require_writable for stage_base_mesh: also an extension that is not known, or that of OBJ, which has room for
/// directions of vertices only, with constant face directions.
///
/// \throws UnwritableFile
void require_writable_base_mesh(const std::filesystem::path& path, bool face_directions);

/// Writes a base mesh under a temporary name, as .ply (binary little endian) or .obj (no ranges, no scan vertices), by
/// the extension of `path`, whatever its case. Every number is stored exactly. `comments` go to the head of the file,
/// one line each. The caller commits the file, once it is content with it.
///
/// \throws UnwritableFile as require_writable_base_mesh; if the disk is full; if the arrays differ in length; or if a
/// value is not a float32 where the file holds one.
[[nodiscard]] AtomicFile stage_base_mesh(const std::filesystem::path& path, const BaseMesh& base,
                                         const std::vector<std::string>& comments);

/// Writes CORRESPONDENCE.ply under a temporary name: one vertex per scan vertex, in scan order, with
/// `x y z base_face alpha0 alpha1 alpha2 t`; x y z are float32 if they are in the scan.
///
/// \throws UnwritableFile as stage_base_mesh.
[[nodiscard]] AtomicFile stage_correspondence(const std::filesystem::path& path, const Scan& scan,
                                              const Correspondence& correspondence);

/// Writes text (a report) under a temporary name.
/// \throws UnwritableFile if the system refuses.
[[nodiscard]] AtomicFile stage_text(const std::filesystem::path& path, const std::string& text);

/// As stage_base_mesh, and commits. On failure an existing file of that name is untouched and no temporary file stays.
void write_base_mesh(const std::filesystem::path& path, const BaseMesh& base, const std::vector<std::string>& comments);

/// As stage_correspondence, and commits.
void write_correspondence(const std::filesystem::path& path, const Scan& scan, const Correspondence& correspondence);

/// As stage_text, and commits.
void write_text(const std::filesystem::path& path, const std::string& text);

} // namespace foldless
