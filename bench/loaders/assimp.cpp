#include "loader.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace {

#ifdef VALIDATING
constexpr unsigned steps = aiProcess_ValidateDataStructure;
#else
constexpr unsigned steps = 0;
#endif

void append(const aiMesh& part, ListedMesh& mesh) {
    const auto first = static_cast<long long>(mesh.points.size());
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        const aiVector3D& point = part.mVertices[i];
        mesh.points.push_back({point.x, point.y, point.z});
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
        const aiFace& face = part.mFaces[i];
        auto& corners = mesh.faces.emplace_back();
        for (unsigned k = 0; k < face.mNumIndices; ++k) {
            // An index behind its part must not look like one into the next.
            corners.push_back(face.mIndices[k] < part.mNumVertices ? first + face.mIndices[k] : -1);
        }
    }
}

} // namespace

bool load(const std::string& path, ListedMesh& mesh) {
    Assimp::Importer importer;
    const aiScene* const scene = importer.ReadFile(path, steps);
    if (scene == nullptr || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0) {
        return false;
    }
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
        append(*scene->mMeshes[i], mesh);
    }
    return true;
}
