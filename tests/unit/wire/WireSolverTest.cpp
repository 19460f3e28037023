#include "WireRig.h"
#include "support/Allocations.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>
#include <random>

namespace insonate {
namespace {

using test::plainWire;
using test::straightVein;
using test::treeOf;
using test::tube;

constexpr double kTolerance_mm = 1;  // a node is at most this far beyond the wall, at the largest force

Vec3 direction(double fromAxis_deg) {
  const double angle = fromAxis_deg * std::numbers::pi / 180;
  return {0, std::sin(angle), std::cos(angle)};
}

/// Needle whose tip lies on the axis of a vein along z.
WireEntry entryAt(double z, double fromAxis_deg) {
  return {{0, 0, z}, direction(fromAxis_deg), direction(fromAxis_deg - 90), 0};
}

double tipDirection(const WireSolver& solver) {
  const auto nodes = solver.nodes_mm();
  return nodes.back().z - nodes.front().z;
}

TEST(WireSolver, StaysStraightOnTheAxisOfAStraightVein) {
  WireSolver solver(treeOf({straightVein(300, 5)}), plainWire(100));
  solver.start(entryAt(20, 0));
  const WireState& state = solver.advance(150);
  EXPECT_EQ(state.refusal, WireRefusal::None);
  EXPECT_NEAR(state.inserted_mm, 150, 1e-9);
  EXPECT_NEAR(state.resistance_N, 0, 1e-3);
  for (const Vec3& node : solver.nodes_mm()) EXPECT_NEAR(std::hypot(node.x, node.y), 0, 1e-3);
  EXPECT_NEAR(solver.nodes_mm().back().z, 170, 0.01);
  EXPECT_EQ(state.tip, WireTip::Lumen);
  EXPECT_EQ(state.system, kVein);
}

TEST(WireSolver, FollowsABentVeinAlongItsOuterWall) {
  constexpr double kBend_mm = 40;
  const auto bent = tube("bent vein", 120, 4, [](double s) {
    const double turn = std::clamp((s - 40) / kBend_mm, 0.0, 1.5);
    const double onward = std::max(s - 40 - 1.5 * kBend_mm, 0.0);
    return Vec3{0, kBend_mm * (1 - std::cos(turn)) + onward * std::sin(turn),
                std::min(s, 40.0) + kBend_mm * std::sin(turn) + onward * std::cos(turn)};
  });
  WireSolver solver(treeOf({bent}), plainWire(50));
  solver.start(entryAt(10, 0));
  const WireState& state = solver.advance(85);
  EXPECT_EQ(state.refusal, WireRefusal::None);
  EXPECT_LT(state.deepest_mm, kTolerance_mm);
  EXPECT_GT(state.at.along_mm, 80);
  EXPECT_GT(state.resistance_N, 0);
  // A wire that bends with the vein lies on the outside of the curve.
  const VesselTree tree = treeOf({bent});
  double outermost_mm = -1e9;
  for (const Vec3& node : solver.nodes_mm())
    outermost_mm = std::max(outermost_mm, tree.wallAt(kVein, node).distance_mm);
  EXPECT_NEAR(outermost_mm, -0.4, 0.4);
}

TEST(WireSolver, NoNodePassesTheWallAndForcesBalance) {
  const Wire wire = loadWire("j-tip").value();
  for (const double angle : {20.0, 35.0, 45.0}) {
    WireSolver solver(treeOf({straightVein(300, 6)}), wire);
    solver.start(entryAt(50, angle));
    for (int mm = 0; mm < 120; ++mm) {
      const WireState& state = solver.advance(1);
      EXPECT_EQ(state.refusal, WireRefusal::None) << angle << ' ' << mm;
      EXPECT_LT(state.deepest_mm, kTolerance_mm) << angle << ' ' << mm;
      EXPECT_LT(state.unbalanced_N, 1e-3) << angle << ' ' << mm;
    }
  }
}

TEST(WireSolver, NarrowVeinUnrollsTheJAndAWideOneLetsItCurl) {
  const auto widening = [] {
    NamedVessel vein = straightVein(200, 1.5);
    for (auto& point : vein.course) point.radius_mm = 1.5 + 8.5 * std::clamp((point.position_mm.z - 60) / 20, 0.0, 1.0);
    return vein;
  }();
  WireSolver solver(treeOf({widening}), loadWire("j-tip").value());
  solver.start(entryAt(5, 0));
  const auto turnOfTheJ_deg = [&] {
    const auto nodes = solver.nodes_mm();
    const Vec3 tip = normalized(nodes.back() - nodes[nodes.size() - 2]);
    const Vec3 body = normalized(nodes[nodes.size() - 9] - nodes[nodes.size() - 10]);
    return std::acos(dot(tip, body)) * 180 / std::numbers::pi;
  };
  solver.advance(45);
  EXPECT_LT(turnOfTheJ_deg(), 60);
  solver.advance(70);
  EXPECT_GT(turnOfTheJ_deg(), 130);
}

TEST(WireSolver, BevelTowardTheHeartSendsTheJThere) {
  for (const double side : {1.0, -1.0}) {
    WireSolver solver(treeOf({straightVein(300, 6)}), loadWire("j-tip").value());
    solver.start({{0, 0, 150}, {0, 1, 0}, {0, 0, side}, 0});
    for (int mm = 0; mm < 40 && solver.state().refusal == WireRefusal::None; ++mm) solver.advance(1);
    EXPECT_GT(side * tipDirection(solver), 10) << side;
  }
}

TEST(WireSolver, NeedleAlongTheVeinDecidesTheDirectionWhateverTheBevel) {
  for (const double roll_deg : {0.0, 90.0, 180.0, 270.0}) {
    WireSolver solver(treeOf({straightVein(300, 6)}), loadWire("j-tip").value());
    WireEntry entry = entryAt(150, 30);
    entry.roll_deg = roll_deg;
    solver.start(entry);
    solver.advance(60);
    EXPECT_GT(tipDirection(solver), 40) << roll_deg;
  }
}

TEST(WireSolver, SteepNeedleRefusesTheBodyOfTheWire) {
  WireSolver solver(treeOf({straightVein(300, 5)}), loadWire("j-tip").value());
  solver.start(entryAt(150, 85));
  const WireState& state = solver.advance(150);
  EXPECT_EQ(state.refusal, WireRefusal::TooSteep) << nameOf(state.refusal);
  EXPECT_LT(state.inserted_mm, 90);
  EXPECT_GT(state.inserted_mm, 5) << "the floppy end turns";
}

TEST(WireSolver, StraightWireStopsAtTheBackWall) {
  WireSolver solver(treeOf({straightVein(300, 6)}), loadWire("straight").value());
  solver.start(entryAt(150, 90));
  const WireState& state = solver.advance(40);
  EXPECT_NE(state.refusal, WireRefusal::None);
  EXPECT_LT(state.inserted_mm, 20);
}

TEST(WireSolver, ClosedEndStopsTheWire) {
  const auto vein = test::tube("small vein", 60, 1.2, [](double s) { return Vec3{0, 0, s}; });
  WireSolver solver(treeOf({vein}), loadWire("straight").value());
  solver.start(entryAt(10, 0));
  const WireState& state = solver.advance(150);
  EXPECT_NE(state.refusal, WireRefusal::None);
  EXPECT_GT(state.resistance_N, 0.2);
}

TEST(WireSolver, TissueAndPosteriorPuncturesRefuseTheWire) {
  WireSolver solver(treeOf({straightVein(300, 5)}), loadWire("j-tip").value());
  solver.start({{0, 8, 150}, direction(45), direction(-45), 0});
  const WireState behind = solver.advance(50);
  EXPECT_EQ(behind.refusal, WireRefusal::ThroughBackWall);
  EXPECT_NEAR(behind.resistance_N, 2, 1e-9);
  EXPECT_LE(behind.inserted_mm, 4);
  EXPECT_EQ(behind.tip, WireTip::Tissue);
  solver.start({{0, -15, 150}, direction(45), direction(-45), 0});
  EXPECT_EQ(solver.advance(50).refusal, WireRefusal::NotInVessel);
}

TEST(WireSolver, WithdrawnWireIsOutAgain) {
  WireSolver solver(treeOf({straightVein(300, 5)}), loadWire("j-tip").value());
  solver.start(entryAt(50, 30));
  solver.advance(80);
  const WireState& state = solver.advance(-200);
  EXPECT_EQ(state.inserted_mm, 0);
  EXPECT_EQ(state.tip, WireTip::InNeedle);
  EXPECT_EQ(solver.nodes_mm().size(), 1U);
  EXPECT_NEAR(solver.advance(30).inserted_mm, 30, 1e-9);
}

TEST(WireSolver, EndOfTheWireIsReported) {
  WireSolver solver(treeOf({straightVein(300, 5)}), plainWire(100, 100));
  solver.start(entryAt(20, 0));
  const WireState& state = solver.advance(150);
  EXPECT_EQ(state.refusal, WireRefusal::EndOfWire);
  EXPECT_NEAR(state.inserted_mm, 100, 1.1);
}

TEST(WireSolver, MirroredVeinGivesTheMirroredWire) {
  const auto curved = [](double side) {
    return tube("vein", 150, 4, [side](double s) { return Vec3{side * 0.004 * s * s, 0, s}; });
  };
  std::vector<Vec3> nodes[2];
  for (const int k : {0, 1}) {
    const double side = k == 0 ? 1 : -1;
    WireSolver solver(treeOf({curved(side)}), loadWire("j-tip").value());
    solver.start({{side * 0.4, 0, 10}, normalized(Vec3{side * 0.2, 0.1, 1}), {side, 0, 0}, 0});
    solver.advance(80);
    nodes[k].assign(solver.nodes_mm().begin(), solver.nodes_mm().end());
  }
  ASSERT_EQ(nodes[0].size(), nodes[1].size());
  for (std::size_t i = 0; i < nodes[0].size(); ++i)
    EXPECT_LT(norm(nodes[0][i] - Vec3{-nodes[1][i].x, nodes[1][i].y, nodes[1][i].z}), 1e-3) << i;
}

TEST(WireSolver, RepeatsBitForBitAndAllocatesNothing) {
  const CaseManifest& neck = test::neckNamed("textbook");
  const VesselTree tree = VesselTree::make(neck.vessels).value();
  const WireEntry entry{neck.targets[0].position_mm, normalized(Vec3{0, 0.6, -0.8}), {0, -0.8, -0.6}, 0};
  WireSolver first(tree, loadWire("j-tip").value()), second(tree, loadWire("j-tip").value());
  first.start(entry), second.start(entry);
  const long before = test::allocations();
  for (int mm = 0; mm < 120; ++mm) first.advance(1), second.advance(1);
  EXPECT_EQ(test::allocations(), before);
  EXPECT_EQ(first.energy_Nmm(), second.energy_Nmm());
  ASSERT_EQ(first.nodes_mm().size(), second.nodes_mm().size());
  EXPECT_TRUE(std::ranges::equal(first.nodes_mm(), second.nodes_mm()));
}

TEST(WireSolver, JugularVeinLeadsToTheAtriumInTheBuiltInNeck) {
  const CaseManifest& neck = test::neckNamed("textbook");
  const VesselTree tree = VesselTree::make(neck.vessels).value();
  WireSolver solver(tree, loadWire("j-tip").value());
  solver.start({neck.targets[0].position_mm, normalized(Vec3{0, 0.5, -0.85}), {0, -0.85, -0.5}, 0});
  for (int mm = 0; mm < 150; ++mm) {
    const WireState& state = solver.advance(1);
    ASSERT_EQ(state.refusal, WireRefusal::None) << mm << ' ' << nameOf(state.refusal);
    EXPECT_LT(state.deepest_mm, kTolerance_mm) << mm;
  }
  EXPECT_EQ(tree.vessels()[solver.state().at.vessel].tube.name, "superior vena cava");
  EXPECT_LT(solver.state().at.toHeart_mm, 40);
}

TEST(WireSolver, AnyNeedleInAnyVeinGivesAWireWithinBounds) {
  const CaseManifest& neck = test::neckNamed("textbook");
  const VesselTree tree = VesselTree::make(neck.vessels).value();
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto any = [&] { return Vec3{normal(random), normal(random), normal(random)}; };
  int refused = 0, unbalanced = 0, steps = 0;
  for (const char* name : {"j-tip", "straight", "triple-lumen", "dilator"}) {
    WireSolver solver(tree, loadWire(name).value());
    for (const NamedVessel& vessel : neck.vessels) {
      const auto& at = vessel.course[vessel.course.size() / 2];
      solver.start({at.position_mm + any() * (0.4 * at.radius_mm), normalized(any()), any(), 0});
      for (int mm = 0; mm < 60; ++mm, ++steps) {
        const WireState& state = solver.advance(2);
        ASSERT_LE(state.resistance_N, 2 + 1e-9) << vessel.name;
        ASSERT_LT(state.deepest_mm, 1.5) << name << ' ' << vessel.name << ' ' << mm;
        for (const Vec3& node : solver.nodes_mm()) ASSERT_TRUE(isFinite(node)) << vessel.name;
        unbalanced += state.unbalanced_N > 0.01;
        if (state.refusal == WireRefusal::None) continue;
        ++refused;
        break;
      }
      solver.advance(-300);
      EXPECT_EQ(solver.state().inserted_mm, 0) << vessel.name;
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_LT(unbalanced, steps / 100);
}

TEST(WireSolver, WireKeepsItsLength) {
  WireSolver solver(treeOf({tube("vein", 200, 4,
                                 [](double s) {
                                   return Vec3{20 * std::sin(s / 25), 0, s};
                                 })}),
                    loadWire("j-tip").value());
  solver.start({{0, 0, 5}, normalized(Vec3{0.6, 0, 1}), {1, 0, 0}, 0});
  const double inserted_mm = solver.advance(120).inserted_mm;
  double length_mm = 0;
  const auto nodes = solver.nodes_mm();
  for (std::size_t i = 1; i < nodes.size(); ++i) length_mm += norm(nodes[i] - nodes[i - 1]);
  EXPECT_NEAR(length_mm / inserted_mm, 1, 1e-3);
}

/// The direction of the J decides in patients, too: Tripathi M et al., Anesth Analg 2005;100:21-24.
TEST(WireSolver, FromTheSubclavianVeinTheJLeadsToTheHeartOrToTheHead) {
  const CaseManifest& neck = test::neckNamed("subclavian");
  const VesselTree tree = VesselTree::make(neck.vessels).value();
  const Vec3 tip_mm = neck.targets[0].position_mm;
  const Vec3 along = tree.locate(kVein, tip_mm).towardHeart;
  const auto vesselOfTip = [&](Vec3 bendsTo) {
    WireSolver solver(tree, loadWire("j-tip").value());
    solver.start({tip_mm, normalized(along + Vec3{0, 0.5, 0}), bendsTo, 0});
    for (int mm = 0; mm < 130; ++mm) EXPECT_EQ(solver.advance(1).refusal, WireRefusal::None);
    return tree.vessels()[solver.state().at.vessel].tube.name;
  };
  EXPECT_EQ(vesselOfTip({0, 0, -1}), "superior vena cava");
  EXPECT_EQ(vesselOfTip({0, 0, 1}), "right internal jugular vein");
}

TEST(WireSolver, FlatVeinOfANeckKeepsTheWireInItsLumen) {
  const PatientCase neck = makePhantom("collapsed-vein", 1, {}).value();
  const VesselTree tree = VesselTree::make(neck.manifest.vessels, &neck.labels).value();
  WireSolver solver(tree, loadWire("j-tip").value());
  solver.start({neck.manifest.targets[0].position_mm, normalized(Vec3{0, 0.3, -0.95}), {0, -0.95, -0.3}, 0});
  for (int mm = 0; mm < 60; ++mm) {
    const WireState& state = solver.advance(1);
    EXPECT_EQ(state.refusal, WireRefusal::None) << mm;
    EXPECT_LT(state.unbalanced_N, 1e-3) << mm;
  }
  // The nodes are in voxels of veins, but for the voxels of the wall.
  const Transform indexFromPatient = neck.labels.geometry.indexFromPatient();
  int inside = 0;
  for (const Vec3& node : solver.nodes_mm()) inside += sampleNearest(neck.labels, indexFromPatient * node) == kVein;
  EXPECT_GE(inside, 0.85 * static_cast<double>(solver.nodes_mm().size()));
}

TEST(WireSolver, FinerNodesAgreeWithTheDefault) {
  const auto run = [](double spacing_mm) {
    const auto curved = tube("vein", 250, 5, [](double s) { return Vec3{20 * std::sin(s / 40), 0, s}; });
    WireSettings settings;
    settings.spacing_mm = spacing_mm, settings.step_mm = spacing_mm / 2, settings.tolerance_N = 1e-6;
    WireSolver solver(treeOf({curved}), loadWire("j-tip").value(), settings);
    solver.start({{0, 0, 5}, normalized(Vec3{0.5, 0, 1}), {0, 1, 0}, 0});
    solver.advance(100);
    return std::vector<Vec3>(solver.nodes_mm().begin(), solver.nodes_mm().end());
  };
  const auto usual = run(2), fine = run(0.5);
  // Compares 60 mm of the body, up to the J.
  for (int mm = 10; mm <= 70; mm += 10) {
    const auto nearest = [&](const std::vector<Vec3>& nodes, Vec3 p) {
      double least_mm = 1e9;
      for (const Vec3& node : nodes) least_mm = std::min(least_mm, norm(node - p));
      return least_mm;
    };
    EXPECT_LT(nearest(fine, usual[mm / 2]), 0.5) << mm;
  }
}

}  // namespace
}  // namespace insonate
