/// \file
/// From the colours and texture coordinates that a reader found to those of a scan.
#pragma once

#include <foldless/io/raw_mesh.h>

namespace foldless {

/// Afterwards there is one colour for each vertex, in [0, 1], or none; one texture triangle for each face, or none; and
/// no texture coordinates of vertices. What is dropped for that is noted. Time O(vertices + faces).
///
/// Without a declared unit, colours are numbers from 0 to 255 if all of them are integers and one is above 1, else from
/// 0 to 1. A program that writes 0 to 1 as text may well write 1 for 1.0, but not 2.
void complete_appearance(RawMesh& mesh);

} // namespace foldless
