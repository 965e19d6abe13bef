#include "engine/equilibrium/ContactSearch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "engine/tool/ToolSolids.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kRadius = 0.02;  // metres
constexpr double kRange = 2e-4;   // metres

/// A ball with the solids of a tool at a pose.
struct BallAndTool {
  BodyModel model = make_body_model(make_body(make_sphere(kRadius, 1280), 1e-3, neo_hookean(20e3)));
  EquilibriumProblem problem;
  EquilibriumTerms terms;

  BallAndTool(const ToolDefinition& tool, const ToolPose& pose) {
    for (const ToolSolid& solid : contact_solids(tool, pose)) {
      problem.solids.push_back({.solid = solid,
                                .range = kRange,
                                .dip = kRange,
                                .hugging_pressure = 1e3,
                                .forces = std::vector<double>(model.sites.size(), 0)});
    }
  }

  std::optional<SolidGap> gap(int solid, int site) const {
    const ContactSite& where = model.sites[site];
    return problem.solids[solid].gap(site, where, problem.solids[solid].solid, std::numeric_limits<double>::infinity(),
                                     corners_of(model.surface[where.triangle], model.rest_position),
                                     GapTerms::kGradient);
  }

  const std::vector<ContactPoint>& find() {
    terms.contacts.clear();
    find_contacts(model, problem, model.rest_position, terms);
    return terms.contacts;
  }

  /// What each solid by itself pushes, looked for at every site, in the order of solids and sites.
  std::vector<std::array<int, 2>> pushed() const {
    std::vector<std::array<int, 2>> result;
    for (int k = 0; k < static_cast<int>(problem.solids.size()); ++k) {
      for (int s = 0; s < static_cast<int>(model.sites.size()); ++s) {
        if (!problem.solids[k].meets(model.sites[s].part)) continue;
        const std::optional<SolidGap> here = gap(k, s);
        if (here->gap < kRange && here->part == model.sites[s].part) result.push_back({k, s});
      }
    }
    return result;
  }
};

const std::vector<ToolDefinition> kTools = {
    {.name = "grip", .kind = ToolKind::kForceps, .length = 0.03, .width = 0.006, .thickness = 0.002, .opening = 0.008},
    {.name = "needle", .kind = ToolKind::kNeedle, .length = 0.04, .radius = 8e-4},
    {.name = "plate", .kind = ToolKind::kPlate, .length = 0.02, .width = 0.01, .thickness = 0.002},
    {.name = "ball", .kind = ToolKind::kSphere, .radius = 4e-3}};

/// Into the ball by up to 2 mm, leaning up to 60 degrees.
ToolPose pose_into_ball(std::mt19937& random) {
  std::uniform_real_distribution<double> part(-1, 1);
  const Eigen::Vector3d out = Eigen::Vector3d(part(random), part(random), part(random)).normalized();
  const Eigen::Vector3d lean = out + 0.5 * Eigen::Vector3d(part(random), part(random), part(random));
  ToolPose pose = pose_at((kRadius - 1e-3 * (1 + part(random))) * out, -lean.normalized());
  pose.opening = 0.004;
  return pose;
}

TEST(ContactSearch, FindsAllThatASolidOrAPartOfItPushesAsEachWouldByItself) {
  std::mt19937 random(7);
  std::size_t pushed_by_parts = 0;
  for (const ToolDefinition& tool : kTools) {
    for (int k = 0; k < 20; ++k) {
      BallAndTool scene(tool, pose_into_ball(random));
      std::vector<std::array<int, 2>> found;
      for (const ContactPoint& contact : scene.find()) {
        EXPECT_EQ(contact.gap.gap, scene.gap(contact.solid, contact.site)->gap);
        if (contact.gap.gap < kRange) found.push_back({contact.solid, contact.site});
        if (contact.gap.gap < kRange && scene.problem.solids[contact.solid].solid.is_part()) ++pushed_by_parts;
      }
      EXPECT_EQ(found, scene.pushed()) << tool.name << ", pose " << k;
    }
  }
  EXPECT_GT(pushed_by_parts, 100U) << "the tools are to lie in the wall";
}

TEST(ContactSearch, KeepsSitesThatAreStillPressedOnWhereTheToolHasGone) {
  for (const ToolDefinition& tool : kTools) {
    BallAndTool scene(tool, pose_at({0, 0, 0.1}, -Eigen::Vector3d::UnitZ()));
    ASSERT_TRUE(scene.find().empty()) << tool.name;
    for (int k = 0; k < static_cast<int>(scene.problem.solids.size()); ++k) {
      SolidContact& contact = scene.problem.solids[k];
      const auto site =
          std::ranges::find_if(scene.model.sites, [&](const ContactSite& s) { return contact.meets(s.part); });
      const auto s = static_cast<int>(site - scene.model.sites.begin());
      contact.forces[s] = 1;
      ASSERT_EQ(scene.find().size(), 1U) << tool.name << ", solid " << k;
      EXPECT_EQ(scene.terms.contacts.front().solid, k);
      EXPECT_EQ(scene.terms.contacts.front().site, s);
      contact.forces[s] = 0;
    }
  }
}

}  // namespace
}  // namespace thinwall
