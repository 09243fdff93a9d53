#include "weights/biharmonic.h"

#include "support/catch.h"
#include "weights/bodies.h"
#include "weights/reference.h"

using namespace marrow;

namespace {

struct Model {
  const char* name;
  Mesh body;
  std::vector<Segment> bones;
};

std::vector<Model> smallModels() {
  std::vector<Model> models;
  const auto arm = straight({0, 0, 0}, {100, 30, 20}, 12);
  models.push_back({"a straight arm", tube(arm, 9), chain({arm[0], arm[4], arm[8], arm[12]})});

  const std::vector<Vec3> bent{{0, 0, 0}, {30, 0, 0}, {50, 20, 0}, {50, 40, 20}, {50, 40, 60}};
  models.push_back({"a bent arm", tube(bent, 8), chain(bent)});

  Mesh star = box({-20, -20, -20}, {20, 20, 20});
  std::vector<Segment> spokes;
  for (const Vec3 tip : {Vec3{70, 0, 0}, {-70, 0, 0}, {0, 70, 0}, {0, 0, -70}}) {
    append(star, tube(straight({0, 0, 0}, tip, 6), 8));
    spokes.push_back({Vec3{0, 0, 0}, tip * 0.4});
    spokes.push_back({tip * 0.4, tip});
  }
  models.push_back({"a body with limbs", star, spokes});

  models.push_back({"bones in the middle of a big lump", box({-50, -40, -30}, {50, 40, 30}),
                    chain({{-20, 0, 0}, {0, 0, 0}, {10, 10, 0}, {12, 14, 9}})});
  return models;
}

Result<Volume> volumeOf(const Model& model, double vertices) {
  VolumeOptions options;
  options.target_vertices = vertices;
  auto volume = makeVolume(model.body, options);
  REQUIRE(volume);
  return volume;
}

}  // namespace

TEST_CASE("biharmonic: the matrix is that of linear tetrahedra") {
  for (const Model& model : smallModels()) {
    INFO(model.name);
    const auto volume = volumeOf(model, 250);
    const SymmetricRows rows = biharmonicMatrix(*volume);
    REQUIRE(rows.size() == volume->vertices.size());
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(rows.size(), rows.size());
    for (uint32_t row = 0; row < rows.size(); ++row) {
      for (uint32_t i = rows.starts[row]; i < rows.starts[row + 1]; ++i) {
        CHECK((i == rows.starts[row] || rows.columns[i] > rows.columns[i - 1]));
        dense(row, rows.columns[i]) = rows.values[i];
      }
    }
    const Eigen::MatrixXd reference = referenceMatrix(*volume);
    CHECK((dense - reference).cwiseAbs().maxCoeff() < 1e-12 * reference.cwiseAbs().maxCoeff());
  }
}

TEST_CASE("biharmonic: the weights are the solution of the quadratic programme") {
  for (const Model& model : smallModels()) {
    INFO(model.name);
    const auto volume = volumeOf(model, 400);
    REQUIRE(volume->piece_count == 1);
    const Handles handles = makeHandles(*volume, model.bones);
    const Eigen::MatrixXd reference = referenceWeights(*volume, handles, model.bones.size());
    REQUIRE(reference.rowwise().sum().minCoeff() > 0.5);

    BoundedBiharmonic usual(*volume, handles);
    BiharmonicOptions patient;
    patient.tolerance = 0;
    patient.most_steps = 100;
    BoundedBiharmonic exact(*volume, handles, patient);
    Eigen::MatrixXd ours(reference.rows(), reference.cols());
    for (uint32_t bone = 0; bone < model.bones.size(); ++bone) {
      INFO("bone " << bone);
      const std::vector<double> weights = usual.solve(bone), converged = exact.solve(bone);
      for (size_t v = 0; v < weights.size(); ++v) {
        REQUIRE(weights[v] >= 0);
        REQUIRE(weights[v] <= 1);
        ours(static_cast<Eigen::Index>(v), bone) = weights[v];
        REQUIRE(std::fabs(converged[v] - reference(static_cast<Eigen::Index>(v), bone)) < 1e-4);
      }
    }
    const auto normalised = [](Eigen::MatrixXd weights) {
      for (Eigen::Index v = 0; v < weights.rows(); ++v) weights.row(v) /= weights.row(v).sum();
      return weights;
    };
    const Eigen::MatrixXd off = (normalised(ours) - normalised(reference)).cwiseAbs();
    INFO("off by " << off.maxCoeff() << ", on average " << off.mean());
    CHECK(off.maxCoeff() < 0.01);
    CHECK(off.mean() < 5e-4);
    // Without bounds they would be something else: the bounds are tested as well.
    patient.most_steps = 0;
    BoundedBiharmonic cut(*volume, handles, patient);
    double most = 0;
    for (uint32_t bone = 0; bone < model.bones.size(); ++bone) {
      const std::vector<double> weights = cut.solve(bone);
      for (size_t v = 0; v < weights.size(); ++v) {
        most =
            std::max(most, std::fabs(weights[v] - reference(static_cast<Eigen::Index>(v), bone)));
      }
    }
    CHECK(most > 0.01);
  }
}

TEST_CASE("biharmonic: a bone's weights stay in the pieces that it holds") {
  Mesh bodies = box({0, 0, 0}, {40, 10, 10});
  append(bodies, box({0, 30, 0}, {40, 40, 10}));
  const std::vector<Segment> bones = chain({{5, 5, 5}, {20, 5, 5}, {35, 5, 5}});
  const auto volume = makeVolume(bodies);
  REQUIRE(volume);
  REQUIRE(volume->piece_count == 2);
  const Handles handles = makeHandles(*volume, bones);
  BoundedBiharmonic solver(*volume, handles);
  for (const uint32_t bone : {0u, 1u, 7u}) {
    const std::vector<double> weights = solver.solve(bone);
    double most = 0;
    for (size_t v = 0; v < weights.size(); ++v) {
      most = std::max(most, weights[v]);
      if (volume->vertices[v].y > 20) CHECK(weights[v] == 0);
    }
    CHECK(most == (bone < 2 ? 1 : 0));
  }
}
