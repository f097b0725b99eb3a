// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "evaluationmodels.h"

#include <cmath>
#include <format>
#include <fstream>

#include "closedmesh.h"
#include "core/base/bytesink.h"
#include "core/base/file.h"
#include "core/formats/fdoreader.h"
#include "core/formats/objwriter.h"
#include "core/fractal/counts.h"
#include "core/scene/sceneloader.h"
#include "tests/bench/render/ourframes.h"

namespace romanesco::bench {

namespace {

/// As programs export meshes.
constexpr int digits = 7;

class FileSink final : public ByteSink
{
public:
    explicit FileSink(const std::filesystem::path &path)
        : m_stream(path, std::ios::binary)
    {
    }

    [[nodiscard]] std::expected<void, std::string> write(std::string_view bytes) override
    {
        m_stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        m_stream.flush();
        return m_stream ? std::expected<void, std::string>() : std::unexpected("cannot write the mesh");
    }

private:
    std::ofstream m_stream;
};

void require(bool holds, const EvaluationModel &model, const std::string &words)
{
    if (!holds) {
        orEnd<int>(std::unexpected(std::format("mesh {}: {}", model.id, words)));
    }
}

EvaluationModel closedModel(EvaluationModel model, Form form)
{
    const Mesh mesh = closedMesh(static_cast<std::uint32_t>(model.faces), form);
    FileSink sink(model.path);
    const auto written = writeObj(PlainMesh(mesh), {.digits = digits}, sink);
    require(written.has_value(), model, written ? "" : written.error());
    const Mesh read = *model.scene()->items.front().model->mesh;
    require(read.faces.size() == model.faces, model, std::format("{} faces", read.faces.size()));
    const std::string flaw = flawOf(read);
    require(flaw.empty(), model, flaw);
    return model;
}

EvaluationModel fractalModel(EvaluationModel model)
{
    const auto &[b, t, d] = *model.shape;
    const Model made = *model.scene()->items.front().model;
    const Count written = instancesAsWritten(made.graph) * Count(made.mesh->faces.size());
    const double power = std::pow(static_cast<double>(t), static_cast<double>(d));
    require(b == made.mesh->faces.size() && written == Count(model.faces)
                && static_cast<double>(b) * power == static_cast<double>(model.faces),
            model, "it is not of the shape that it is said to be");
    return model;
}

}

std::string EvaluationModel::text() const
{
    std::string text = orEnd(DiskFiles().read(path));
    if (depth) {
        const SourceRange range = readFdo(text).description.value().depth.value().range;
        text.replace(range.begin, range.length(), std::to_string(*depth));
    }
    return text;
}

std::shared_ptr<const Scene> EvaluationModel::scene() const
{
    SceneResult result = SceneLoader(DiskFiles()).load(path, text());
    require(result.scene != nullptr, *this, "it cannot be read");
    return result.scene;
}

std::uint64_t EvaluationModel::fileBytes() const
{
    const std::string text = this->text();
    const std::uint64_t ofMesh =
        shape ? std::filesystem::file_size(path.parent_path() / readFdo(text).description.value().meshPath) : 0;
    return text.size() + ofMesh;
}

std::vector<EvaluationModel> evaluationModels(const std::filesystem::path &folder)
{
    const std::filesystem::path top(ROMANESCO_SOURCE_DIR);
    const std::filesystem::path examples = top / "resources/examples";
    const std::filesystem::path ofTests = top / "tests/data/collide";
    const Published third{0.231, 749, 420, 1'666};
    std::vector<EvaluationModel> models;
    models.push_back(closedModel({.id = "1",
                                  .title = "boulder",
                                  .path = folder / "boulder.obj",
                                  .faces = 277'654,
                                  .published = {85.577, 10'799'578, 277'654, 1'736}},
                                 Form::Boulder));
    models.push_back(closedModel({.id = "2",
                                  .title = "stump",
                                  .path = folder / "stump.obj",
                                  .faces = 237'664,
                                  .published = {74.467, 36'871'183, 237'664, 1'714}},
                                 Form::Stump));
    models.push_back(fractalModel({.id = "3",
                                   .title = "tree of 7",
                                   .path = ofTests / "tree7.fdo",
                                   .faces = 168'070,
                                   .published = third,
                                   .shape = Shape{10, 7, 5}}));
    models.push_back(fractalModel({.id = "3b",
                                   .title = "mild tree",
                                   .path = ofTests / "mild-tree.fdo",
                                   .faces = 168'070,
                                   .published = third,
                                   .shape = Shape{10, 7, 5}}));
    models.push_back(fractalModel({.id = "4",
                                   .title = "two sets",
                                   .path = examples / "two-sets.fdo",
                                   .faces = 1'176'490,
                                   .published = {0.075, 1'176, 1'470, 1'936},
                                   .shape = Shape{10, 49, 3}}));
    models.push_back(fractalModel({.id = "5",
                                   .title = "Menger",
                                   .path = examples / "menger.fdo",
                                   .faces = 38'400'000,
                                   .published = {0.741, 1'049, 1'200, 2'419},
                                   .shape = Shape{12, 20, 5},
                                   .depth = 5}));
    return models;
}

}
