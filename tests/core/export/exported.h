// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include "core/export/exporter.h"
#include "core/scene/sceneloader.h"
#include "tests/core/scene/tablefiles.h"

/// What exports are made of and how they are read back, by another program or by a few lines that share nothing with ours.
namespace romanesco::test {

class StringSink final : public ByteSink
{
public:
    [[nodiscard]] std::expected<void, std::string> write(std::string_view bytes) override
    {
        text += bytes;
        return {};
    }
    std::string text;
};

/// The bytes of an export, or the reason why there are none.
inline std::string exported(const Scene &scene, const ExportOptions &options = {})
{
    StringSink sink;
    const auto report = exportScene(scene, options, sink);
    return report ? std::move(sink.text) : "error: " + report.error();
}

/// A mesh by itself.
inline std::shared_ptr<const Model> modelOfMesh(std::shared_ptr<const Mesh> mesh)
{
    FractalGraph graph = FractalGraph::ofMesh(boundingSphere(*mesh));
    return std::make_shared<const Model>(Model{std::move(mesh), std::move(graph), {}, {}, {}});
}

inline std::shared_ptr<const Scene> loaded(const TableFiles &files, const std::string &path)
{
    const SceneResult result = SceneLoader(files).load(path, files.read(path).value());
    return result.scene;
}

/// An OBJ with the faces of a cube, those on opposite sides cut along the same diagonal.
inline const std::string unitCubeObj = "v -.5 -.5 -.5\nv .5 -.5 -.5\nv -.5 .5 -.5\nv .5 .5 -.5\n"
                                       "v -.5 -.5 .5\nv .5 -.5 .5\nv -.5 .5 .5\nv .5 .5 .5\n"
                                       "f 1 3 4\nf 1 4 2\nf 5 6 8\nf 5 8 7\nf 1 2 6\nf 1 6 5\n"
                                       "f 3 7 8\nf 3 8 4\nf 1 5 7\nf 1 7 3\nf 2 4 8\nf 2 8 6\n";

/// Copies of a third of the size of a cube at some of the 27 places that a cube has.
template<typename IsTaken>
std::shared_ptr<const Scene> spongeOf(int depth, const IsTaken &isTaken,
                                      const std::string &third = "0.33333333333333333")
{
    std::string text = "x. \"cube.obj\"\nthird " + third + " " + third + " " + third + "\nbox.p. (p, #, third)\n";
    std::string set;
    for (int i = 0; i < 27; ++i) {
        const std::array<int, 3> place{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
        if (isTaken(place)) {
            const std::string name = "p" + std::to_string(i);
            text += name;
            for (const int coordinate : place) {
                text += coordinate == 0 ? " 0" : coordinate < 0 ? " -0.33333333333333333" : " 0.33333333333333333";
            }
            text += "\n";
            set += (set.empty() ? "box." : ", box.") + name;
        }
    }
    text += "z<x>. [" + set + "] x\n<$>. z " + std::to_string(depth) + "\n";
    return loaded(TableFiles({{"cube.obj", unitCubeObj}, {"a.fdo", text}}), "a.fdo");
}

inline bool isInMenger(const std::array<int, 3> &place)
{
    return (place[0] == 0) + (place[1] == 0) + (place[2] == 0) < 2;
}

inline std::shared_ptr<const Scene> menger(int depth)
{
    return spongeOf(depth, isInMenger);
}

/// Its cubes are a little too small for their places.
inline std::shared_ptr<const Scene> roughMenger(int depth)
{
    return spongeOf(depth, isInMenger, "0.3333333333");
}

inline std::shared_ptr<const Scene> cantorDust(int depth)
{
    return spongeOf(depth, [](const std::array<int, 3> &place) { return place[0] * place[1] * place[2] != 0; });
}

/// Edge 2·√2.
inline std::shared_ptr<const Scene> sierpinski(int depth)
{
    const std::string text = "x. \"tetrahedron.obj\"\na .5 .5 .5\nb .5 -.5 -.5\nc -.5 .5 -.5\nd -.5 -.5 .5\n"
                             "half .5 .5 .5\nt.p. (p, #, half)\nz<x>. [t.a, t.b, t.c, t.d] x\n<$>. z "
        + std::to_string(depth) + "\n";
    const std::string mesh = "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";
    return loaded(TableFiles({{"tetrahedron.obj", mesh}, {"a.fdo", text}}), "a.fdo");
}

using Corner = std::array<double, 3>;
using Triangle = std::array<Corner, 3>;

struct Solid {
    std::size_t faces = 0;
    double area = 0.0;
    /// By the divergence theorem: positive where faces look outwards.
    double volume = 0.0;
};

inline Solid solidOf(const std::vector<Triangle> &triangles)
{
    Solid solid;
    solid.faces = triangles.size();
    for (const auto &[a, b, c] : triangles) {
        const Corner u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const Corner v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        const Corner n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        solid.area += std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
        solid.volume += (a[0] * n[0] + a[1] * n[1] + a[2] * n[2]) / 6;
    }
    return solid;
}

/// As assimp reads the bytes, which knows the format by the ending.
inline const aiScene *imported(Assimp::Importer &importer, const std::string &bytes, const char *ending)
{
    return importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, ending);
}

inline std::vector<Triangle> trianglesOf(const aiScene &scene)
{
    std::vector<Triangle> triangles;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        const aiMesh &mesh = *scene.mMeshes[i];
        for (unsigned face = 0; face < mesh.mNumFaces; ++face) {
            Triangle &triangle = triangles.emplace_back();
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const aiVector3D &v = mesh.mVertices[mesh.mFaces[face].mIndices[corner]];
                triangle[corner] = {v.x, v.y, v.z};
            }
        }
    }
    return triangles;
}

inline std::vector<Triangle> importedTriangles(const std::string &bytes, const char *ending)
{
    Assimp::Importer importer;
    const aiScene *scene = imported(importer, bytes, ending);
    return scene ? trianglesOf(*scene) : std::vector<Triangle>();
}

/// The lines of a text with a keyword, split at blanks, without it.
inline std::vector<std::vector<std::string>> linesOf(const std::string &text, const std::string &keyword)
{
    std::vector<std::vector<std::string>> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == keyword) {
            std::vector<std::string> &rest = lines.emplace_back();
            while (words >> word) {
                rest.push_back(word);
            }
        }
    }
    return lines;
}

/// The triangles of an OBJ text to the last bit, which assimp's floats cannot tell.
inline std::vector<Triangle> exactTriangles(const std::string &obj)
{
    std::vector<Corner> vertices;
    for (const std::vector<std::string> &words : linesOf(obj, "v")) {
        vertices.push_back({std::strtod(words.at(0).c_str(), nullptr), std::strtod(words.at(1).c_str(), nullptr),
                            std::strtod(words.at(2).c_str(), nullptr)});
    }
    std::vector<Triangle> triangles;
    for (const std::vector<std::string> &words : linesOf(obj, "f")) {
        Triangle &triangle = triangles.emplace_back();
        for (std::size_t corner = 0; corner < 3; ++corner) {
            triangle[corner] = vertices.at(std::strtoull(words.at(corner).c_str(), nullptr, 10) - 1);
        }
    }
    return triangles;
}

}
