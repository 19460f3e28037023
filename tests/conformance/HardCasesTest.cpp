#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <cmath>

namespace insonate::test {
namespace {

class HardCases : public EngineTest {
 protected:
  Probe probe_ = probeNamed("linear");
  ImagingSettings settings_ = settingsFor(probe_);
  AcousticTable table_ = *loadAcousticTable("neck");

  HardCases() { settings_.scanlines = 96, settings_.samples = 300; }

  EnvelopeFrame frameOf(const LabelPhantom& phantom, const Transform& pose = {}) {
    const auto& grid = phantom.labels.geometry;
    const Vec3 c = grid.center_mm(), half{200, 200, 200};
    const EnvelopeFrame frame = render(probe_, settings_, sceneOf(phantom, table_, {c - half, c + half}), pose);
    EXPECT_TRUE(allFinite(frame));
    EXPECT_EQ(frame.amplitude.size(), std::size_t(96) * 300 * 3);
    return frame;
  }
};
INSONATE_FOR_ALL_ENGINES(HardCases);

/// Voxel faces at z = 0, voxel centers at x = 0.
const VolumeGeometry kGrid = gridOver({-30.1, -11.9, -25.2}, {30.1, 11.9, 50.4}, 1.4);

/// Level skin at z = 0 over muscle.
LabelPhantom slab(Label tissue = kMuscle) {
  return paint(kGrid, [=](Vec3 p) { return p.z < 0 ? kBackground : tissue; });
}

double heard(const EnvelopeFrame& frame, int firstLine, int endLine) {
  return rms(valuesIn(frame, {20, frame.samples / 2, firstLine, endLine}));
}

TEST_P(HardCases, ProbeHalfOffTheSkinHearsWithTheOtherHalf) {
  const auto corner = paint(kGrid, [](Vec3 p) { return p.z < 0 || p.x > 0 ? kBackground : kMuscle; });
  const EnvelopeFrame frame = frameOf(corner);
  EXPECT_GT(heard(frame, 4, 40), 0.05);
  // Beyond the skirts of its beam, 6 mm from the edge.
  EXPECT_LT(heard(frame, 66, 92), 1e-3 * heard(frame, 4, 40));
}

TEST_P(HardCases, ProbeOffTheBodyHearsNothing) {
  EXPECT_EQ(largest(frameOf(slab(), moved({0, 0, -15}))), 0) << "in the air above the skin";
  const auto scene = sceneOf(slab(), table_, {{-30, -12, -25}, {30, 12, 50}});
  EXPECT_EQ(largest(render(probe_, settings_, scene, moved({500, 0, 0}))), 0) << "far outside the volume";
}

TEST_P(HardCases, LiftingTheProbeLosesContactGradually) {
  settings_.effects.speckle = settings_.effects.texture = false;
  double last = 1e9;
  for (const double lift_mm : {0.0, 4.0, 7.0, 9.0, 11.0, 13.0}) {
    const double level = heard(frameOf(slab(), moved({0, 0, -lift_mm})), 10, 86);
    EXPECT_LE(level, last * 1.02) << lift_mm << " mm above the skin";
    last = level;
  }
  EXPECT_EQ(last, 0);
}

TEST_P(HardCases, TiltedSixtyDegrees) {
  for (const Vec3 axis : {Vec3{1, 0, 0}, {0, 1, 0}}) {
    const EnvelopeFrame frame = frameOf(slab(), turned(axis, 60));
    EXPECT_GT(heard(frame, 40, 56), 0.01) << "the middle of the face stays on the skin";
  }
}

TEST_P(HardCases, InsideTheBody) {
  EXPECT_GT(heard(frameOf(slab(), moved({0, 0, 15})), 10, 86), 0.05);
}

TEST_P(HardCases, InsideBoneOrAir) {
  frameOf(slab(kBone), moved({0, 0, 20}));
  EXPECT_LT(heard(frameOf(slab(kAirway), moved({0, 0, 20})), 10, 86), 0.1) << "gas hardly scatters";
}

TEST_P(HardCases, ColumnOfAirLetsNothingThrough) {
  settings_.effects.reverberation = false;
  const auto column = paint(kGrid, [](Vec3 p) {
    return p.z < 0 ? kBackground : std::abs(p.x) < 6 && p.z > 10 ? kAirway : kMuscle;
  });
  const EnvelopeFrame frame = frameOf(column);
  const double behind = rms(valuesIn(frame, {110, 290, 44, 52})), beside = rms(valuesIn(frame, {110, 290, 8, 24}));
  EXPECT_LT(behind, 1e-2 * beside);
  EXPECT_GT(largest(frame), 10) << "the surface of the air is bright";
}

TEST_P(HardCases, UnknownLabelIsSoftTissueAndIsTold) {
  const auto unknown = paint(kGrid, [](Vec3) { return 200; });
  const auto known = paint(unknown.labels.geometry, [](Vec3) { return kSoftTissue; });
  const Region region{{-30, -12, -25}, {30, 12, 50}};
  const ScenePtr scene = sceneOf(unknown, table_, region);
  ASSERT_EQ(scene->warnings().size(), 1U);
  EXPECT_NE(scene->warnings()[0].find("200"), std::string::npos);
  EXPECT_TRUE(identical(render(probe_, settings_, scene), render(probe_, settings_, sceneOf(known, table_, region))));
}

TEST_P(HardCases, EveryLabelValueAtOnce) {
  frameOf(paint(kGrid,
                [](Vec3 p) { return (int(p.x + 40) / 3 * 7 + int(p.y + 40) / 3 * 5 + int(p.z + 40) / 3 * 3) & 255; }));
}

TEST_P(HardCases, OneVoxelVesselIsSeen) {
  const auto vessel = paint(kGrid, [](Vec3 p) {
    return p.z < 0 ? kBackground : std::abs(p.x) < 0.4 && std::abs(p.z - 16.1) < 0.4 ? kVein : kMuscle;
  });
  const EnvelopeFrame with = frameOf(vessel), without = frameOf(slab());
  const Window at{int(14.6 / 40 * 300), int(17.6 / 40 * 300), 44, 52};
  EXPECT_GT(std::abs(rms(valuesIn(with, at)) / rms(valuesIn(without, at)) - 1), 0.05);
  const Window far{30, 80, 4, 30};
  EXPECT_NEAR(rms(valuesIn(with, far)) / rms(valuesIn(without, far)), 1, 0.01);
}

TEST_P(HardCases, EmptyLabelMapHearsNothing) {
  const auto empty = paint(kGrid, [](Vec3) { return kBackground; });
  EXPECT_EQ(largest(frameOf(empty)), 0);
}

TEST_P(HardCases, OneSliceOfCtShowsItsPlane) {
  settings_.elevationPlanes = 1;
  for (const double thickness_mm : {1.0, 5.0}) {
    const auto slice = paint(gridOver({-30, -thickness_mm / 2, -25}, {30, thickness_mm / 2, 50}, {1, thickness_mm, 1}),
                             [](Vec3 p) { return p.z < 0 ? kBackground : kMuscle; });
    ASSERT_EQ(slice.labels.geometry.size[1], 1);
    EXPECT_GT(heard(frameOf(slice), 10, 86), 0.05);
    EXPECT_GT(heard(frameOf(slice, moved({0, 0.4 * thickness_mm, 0})), 10, 86), 0.05) << "within the slice";
    EXPECT_EQ(largest(frameOf(slice, moved({0, 0.6 * thickness_mm + 0.5, 0}))), 0) << "beside the slice";
  }
}

TEST_P(HardCases, OneVoxelIsAVolumeToo) {
  frameOf(paint(gridOver({-30, -12, -25}, {30, 12, 50}, 100), [](Vec3) { return kMuscle; }));
}

TEST_P(HardCases, PaddingAndMetalInTheCtAreNoMoreThanTissue) {
  for (AcousticTissue& tissue : table_.tissues) tissue.ctImpedancePer100HU = 0.03, tissue.ctEchogenicity_dBper100HU = 6;
  const auto labelAt = [](Vec3 p) { return p.z < 0 ? kBackground : kMuscle; };
  for (const int hu : {-3024, 32767, -32768}) {
    const EnvelopeFrame frame = frameOf(paint(kGrid, labelAt, [=](Vec3 p) { return p.x < 0 ? hu : 50; }));
    EXPECT_LT(largest(frame), 1e4) << hu;
    EXPECT_GT(heard(frame, 10, 86), 1e-3) << hu;
  }
}

TEST_P(HardCases, GridsThatDifferAreRefused) {
  LabelPhantom phantom = slab();
  phantom.ct = CtVolume(gridOver({-30, -12, -25}, {30, 12, 50}, 2));
  const auto scene = AcousticScene::make(phantom.ct, phantom.labels, table_, {{-30, -12, -25}, {30, 12, 50}});
  ASSERT_FALSE(scene);
  EXPECT_NE(scene.error().message.find("grid"), std::string::npos);
}

TEST_P(HardCases, RegionOutsideTheVolumeIsRefused) {
  const LabelPhantom phantom = slab();
  const auto scene = AcousticScene::make(phantom.ct, phantom.labels, table_, {{500, 0, 0}, {600, 10, 10}});
  ASSERT_FALSE(scene);
  EXPECT_FALSE(scene.error().message.empty());
}

TEST_P(HardCases, EveryProbeAtItsSmallestAndLargest) {
  for (const char* name : {"linear", "curvilinear", "phased"}) {
    const Probe probe = probeNamed(name);
    for (const bool deep : {false, true})
      for (const auto& [scanlines, samples] : {std::pair{16, 64}, {65, 70}}) {
        ImagingSettings settings = settingsFor(probe);
        settings.depth_mm = deep ? probe.maxDepth_mm : probe.minDepth_mm;
        settings.frequency_MHz = deep ? probe.minFrequency_MHz : probe.maxFrequency_MHz;
        settings.scanlines = scanlines, settings.samples = samples;
        const auto scene = sceneOf(slab(), table_, {{-30, -12, -25}, {30, 12, 50}});
        const EnvelopeFrame frame = render(probe, settings, scene, moved({0, 0, -0.5}));
        EXPECT_TRUE(allFinite(frame)) << name;
        EXPECT_GT(largest(frame), 0) << name;
      }
  }
}

}  // namespace
}  // namespace insonate::test
