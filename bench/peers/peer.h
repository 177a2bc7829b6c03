// A decimator of another library: `PROGRAM IN.ply OUT.ply FACES`.
#pragma once

#include "plain_mesh.h"

#include <cstddef>
#include <memory>

// A mesh in the structure of a library.
class Peer {
public:
    virtual ~Peer() = default;

    // Stops at the first state with at most so many faces, or where the library goes no further.
    virtual void decimate(std::size_t faces) = 0;

    virtual PlainMesh result() const = 0;
};

// Each program has its own. Throws std::runtime_error if the library does not take the mesh.
std::unique_ptr<Peer> make_peer(const PlainMesh& scan);
