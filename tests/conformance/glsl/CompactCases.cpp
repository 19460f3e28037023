#include "conformance/glsl/CompactCases.h"

#include <cmath>

namespace insonate::test {
namespace {

/// Part of a limb, its axis along patient z: vessels, airway and bone near the skin, so that a shallow frame has all.
LabelPhantom limb() {
  return paint(
      gridOver({-26, -56, -8}, {26, -18, 8}, {0.7, 0.7, 1.4}),
      [](Vec3 p) {
        const double r = std::hypot(p.x, p.y);
        if (r > 50) return kBackground;
        if (r > 48) return kSkin;
        if (r > 44) return kFat;
        if (std::hypot(p.x - 7, p.y + 38 + 0.3 * p.z) < 3.5) return kVein;
        if (std::hypot(p.x + 5, p.y + 37) < 2.5) return kArtery;
        if (std::hypot(p.x, p.y + 28) < 4) return kAirway;
        if (std::hypot(p.x - 12, p.y + 29) < 4) return kBone;
        if (std::hypot(p.x + 13, p.y + 32) < 4) return kThyroid;
        return r > 38 ? kSternocleidomastoid : kMuscle;
      },
      [](Vec3 p) { return std::lround(40 + 60 * std::sin(p.x) * std::cos(0.7 * p.y) + 30 * std::sin(0.5 * p.z)); });
}

/// The neck's values, with what they leave out.
AcousticTable variedTable() {
  AcousticTable table = *loadAcousticTable("neck");
  for (AcousticTissue& tissue : table.tissues)
    tissue.ctImpedancePer100HU += 0.02, tissue.ctEchogenicity_dBper100HU += 2, tissue.roughness_dB += 1;
  table.tissues[kThyroid].specularDiffuse = 0.5, table.tissues[kThyroid].specularExponent = 3;
  return table;
}

Transform onSkin(double pressed_mm = 0) {
  Transform pose;
  pose.linear = {{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}};
  pose.offset = {0, -50 + pressed_mm, 0};
  return pose * turned({0.2, 0.3, 1}, 5);
}

PlaneDisplacement squeezed(const Probe& probe, const ImagingSettings& settings) {
  return displacementOver(probe, settings, 0.9, [](double x, double z) {
    const auto swirl = swirlAt(x, z, 2, 9, 25, 6);
    const double into = std::exp(-std::max(z, 0.0) / 12);
    return shiftBy(swirl.x_mm - 0.08 * x * into, swirl.z_mm - 3 * into);
  });
}

class Cases {
 public:
  std::vector<CompactCase> all;

  template <class Change>
  CompactCase& add(const std::string& what, const char* probeName, const ScenePtr& scene, const Transform& pose,
                   const Change& change) {
    const Probe probe = probeNamed(probeName);
    ImagingSettings settings = settingsFor(probe);
    settings.scanlines = 40, settings.samples = 150, settings.depth_mm = probe.minDepth_mm, settings.looks = 1;
    change(settings);
    return all.emplace_back(CompactCase{what, probe, settings, scene, pose, {}});
  }
};

constexpr auto kAsItIs = [](ImagingSettings&) {};

void addPoses(Cases& cases, const ScenePtr& scene) {
  cases.add("linear", "linear", scene, onSkin(), [](auto& s) { s.looks = 3; });
  cases.add("two scanlines a cell", "linear", scene, onSkin(1), [](auto& s) { s.scanlines = 200, s.samples = 160; });
  cases.add("5 planes", "linear", scene, onSkin(1), [](auto& s) { s.elevationPlanes = 5, s.scanlines = 24; });
  cases.add("1 plane", "linear", scene, onSkin(1), [](auto& s) { s.elevationPlanes = 1; });
  cases.add("coarse samples", "linear", scene, onSkin(1), [](auto& s) { s.samples = 64; });
  cases.add("fine samples", "linear", scene, onSkin(1), [](auto& s) { s.samples = 600, s.scanlines = 20; });
  cases.add("fan", "curvilinear", scene, onSkin(1), [](auto& s) { s.samples = 400; });
  cases.add("phased", "phased", scene, onSkin(1), [](auto& s) { s.samples = 500, s.elevationPlanes = 1; });
  cases.add("lifted", "linear", scene, onSkin(-5), kAsItIs);
  cases.add("hardly in contact", "linear", scene, onSkin(-7.3), kAsItIs);
  cases.add("rigid skin", "linear", scene, onSkin(-4), [](auto& s) { s.conformingContact = false; });
  cases.add("in the skin", "linear", scene, onSkin(4), kAsItIs);
  cases.add("deep in the skin", "linear", scene, onSkin(10), kAsItIs);
  cases.add("deep inside", "linear", scene, onSkin(20), kAsItIs);
  cases.add("rocked", "linear", scene, onSkin() * turned({0, 1, 0}, 40), kAsItIs);
  cases.add("beside the volume", "linear", scene, onSkin() * moved({14, 0, 0}), kAsItIs);
  cases.add("at its end", "linear", scene, onSkin() * moved({0, 7, 0}), kAsItIs);
}

void addEffects(Cases& cases, const ScenePtr& scene) {
  for (bool Effects::*effect :
       {&Effects::scattering, &Effects::reflection, &Effects::attenuation, &Effects::transmission, &Effects::speckle,
        &Effects::layers, &Effects::texture, &Effects::beam, &Effects::reverberation, &Effects::edgeShadow})
    cases.add("an effect left out", "linear", scene, onSkin(), [=](auto& s) { s.effects.*effect = false; });
  // Each alone, where others would drown it.
  const auto only = [](std::initializer_list<bool Effects::*> effects) {
    return [=](ImagingSettings& s) {
      for (bool Effects::*effect :
           {&Effects::scattering, &Effects::reflection, &Effects::attenuation, &Effects::transmission,
            &Effects::speckle, &Effects::layers, &Effects::texture, &Effects::reverberation, &Effects::edgeShadow})
        s.effects.*effect = false;
      for (bool Effects::*effect : effects) s.effects.*effect = true;
    };
  };
  cases.add("layers alone", "linear", scene, onSkin(1), only({&Effects::scattering, &Effects::layers}));
  cases.add("texture alone", "linear", scene, onSkin(1), only({&Effects::scattering, &Effects::texture}));
  cases.add("sheets in speckle", "linear", scene, onSkin(1),
            only({&Effects::scattering, &Effects::texture, &Effects::layers, &Effects::speckle}));
  cases.add("edges alone", "linear", scene, onSkin(1),
            only({&Effects::scattering, &Effects::attenuation, &Effects::edgeShadow}));
  cases.add("boundaries alone", "linear", scene, onSkin(1), only({&Effects::reflection}));
  cases.add("rough boundaries alone", "linear", scene, onSkin(1), only({&Effects::reflection, &Effects::texture}));
  cases.add("gas alone", "linear", scene, onSkin(1), only({&Effects::scattering, &Effects::reverberation}));
}

/// A lung that slides, whose echoes differ from those of the airway between both lungs.
void addLung(Cases& cases) {
  const Region region{{-80, -56, -8}, {80, -18, 8}};
  const ScenePtr scene =
      sceneOf(paint(gridOver(region.low_mm, region.high_mm, 1.4), [](Vec3 p) { return p.y < -44 ? kMuscle : kAirway; }),
              variedTable(), region);
  for (const double side_mm : {-50.0, 50.0}) {
    Transform pose = onSkin();
    pose.offset.x += side_mm;
    CompactCase& c = cases.add("lung", "linear", scene, pose, kAsItIs);
    c.displacement.lung.slide_mm = 2.3;
    CompactCase& d = cases.add("lung point", "linear", scene, pose, kAsItIs);
    d.displacement.lung = {2.3, side_mm < 0 ? std::array{-side_mm, 0.0} : std::array{0.0, side_mm}};
  }
}

void addDisplaced(Cases& cases, const ScenePtr& scene, Look look) {
  for (const char* probe : {"linear", "curvilinear"})
    for (const int planes : {1, 3})
      for (const double pressed_mm : {3.0, 0.5}) {
        CompactCase& c = cases.add("displaced", probe, scene, onSkin(pressed_mm), [&](auto& s) {
          s.look = look, s.elevationPlanes = planes;
          if (s.depth_mm > 20) s.samples = 400;
        });
        c.displacement = squeezed(c.probe, c.settings);
      }
  CompactCase& beyond = cases.add("from beyond the scene", "linear", scene, onSkin(), [=](auto& s) { s.look = look; });
  beyond.displacement =
      displacementOver(beyond.probe, beyond.settings, 1, [](double, double) { return shiftBy(12, 14); });
  CompactCase& even = cases.add("one point", "linear", scene, onSkin(), [=](auto& s) { s.look = look; });
  even.displacement = {.left_mm = 5, .top_mm = 5, .step_mm = 1, .columns = 1, .rows = 1, .restFromDisplayed = {}};
  even.displacement.restFromDisplayed = {shiftBy(1, 2)};
}

void addNeedles(Cases& cases, const ScenePtr& scene) {
  const auto add = [&](const char* what, const char* probe, double pressed_mm, Vec3 tip_mm, Vec3 direction,
                       auto change) -> CompactCase& {
    CompactCase& c = cases.add(what, probe, scene, onSkin(pressed_mm), [&](auto& s) {
      if (s.depth_mm > 20) s.samples = 400;
      change(s);
    });
    c.needle = needleAt(tip_mm, direction, c.pose);
    return c;
  };
  add("needle in the plane", "linear", 1, {4, 0, 12}, {1.5, 0, 1}, [](auto& s) { s.looks = 2; });
  add("needle square to the beam", "linear", 1, {8, 0, 6}, {1, 0, 0}, kAsItIs);
  add("needle across", "linear", 1, {3, 9, 9}, {0, 1, 0}, kAsItIs);
  add("needle oblique", "linear", 0, {4, 1, 12}, {1, 0.5, 1}, [](auto& s) { s.elevationPlanes = 5; });
  add("needle in a single plane", "linear", 1, {0, 0, 9}, {1, 0, 1}, [](auto& s) { s.elevationPlanes = 1; });
  add("needle through drawn tissue", "linear", -5, {4, 0, 11}, {1, 0, 0.5}, kAsItIs);
  add("needle near the bottom", "linear", 1, {6, 0, 19.5}, {1, 0, 0.1}, kAsItIs);
  add("needle at the face", "linear", 1, {6, 0, 0.7}, {1, 0, 0}, kAsItIs);
  add("needle in a fan", "curvilinear", 1, {6, 0, 14}, {1, 0, 1}, kAsItIs);
  add("needle in a phased fan", "phased", 1, {3, 0, 14}, {1, 0, 1}, kAsItIs);
  add("needle echo alone", "linear", 1, {4, 0, 10}, {1, 0, 0.3},
      [](auto& s) { s.effects.scattering = s.effects.transmission = s.effects.layers = false; });
  add("needle without rings", "linear", 1, {4, 0, 8}, {1, 0, 0}, [](auto& s) { s.effects.reverberation = false; });
  add("needle's shadow alone", "linear", 1, {4, 0, 8}, {1, 0, 0}, [](auto& s) { s.effects.reflection = false; });
  add("needle's shadow on boundaries", "linear", 1, {4, 0, 3}, {1, 0, 0},
      [](auto& s) { s.effects.scattering = false, s.effects.layers = false; });
  CompactCase& displaced = add("needle in displaced tissue", "linear", 3, {4, 0, 12}, {1, 0, 1}, kAsItIs);
  displaced.displacement = squeezed(displaced.probe, displaced.settings);
}

void addThesis(Cases& cases, const ScenePtr& scene) {
  const auto thesis = [](auto change) { return [=](ImagingSettings& s) { s.look = Look::Thesis, change(s); }; };
  cases.add("thesis", "linear", scene, onSkin(1), thesis(kAsItIs));
  cases.add("thesis, 1 plane", "linear", scene, onSkin(1), thesis([](auto& s) { s.elevationPlanes = 1; }));
  cases.add("thesis, lifted", "linear", scene, onSkin(-7.3), thesis(kAsItIs));
  cases.add("thesis, fan", "curvilinear", scene, onSkin(1), thesis([](auto& s) { s.samples = 400; }));
  cases.add("thesis, two scanlines a cell", "linear", scene, onSkin(1), thesis([](auto& s) { s.scanlines = 200; }));
  cases.add("thesis, at the end", "linear", scene, onSkin() * moved({0, 6, 0}), thesis(kAsItIs));
  cases.add("thesis, beside the volume", "linear", scene, onSkin() * moved({14, 0, 0}), thesis(kAsItIs));
  for (bool Effects::*effect : {&Effects::scattering, &Effects::reflection, &Effects::attenuation,
                                &Effects::transmission, &Effects::speckle, &Effects::texture, &Effects::beam})
    cases.add("thesis, an effect left out", "linear", scene, onSkin(1),
              thesis([=](auto& s) { s.effects.*effect = false; }));
}

ScenePtr evenBlock(Label label) {
  const Region region{{-30, -60, -12}, {30, -10, 12}};
  return sceneOf(paint(gridOver({-26, -56, -8}, {26, -18, 8}, 1.4), [=](Vec3) { return label; }), variedTable(),
                 region);
}

}  // namespace

std::vector<CompactCase> compactCases() {
  const Region region{{-30, -60, -12}, {30, -10, 12}};
  const LabelPhantom phantom = limb();
  const ScenePtr scene = sceneOf(phantom, variedTable(), region);
  const ScenePtr thesisScene = sceneOf(phantom, *loadAcousticTable("thesis"), region);
  const ScenePtr withPoints =
      sceneOf(phantom, variedTable(), region, {{{4, -41, 0.3}, 50}, {{4.2, -41.1, 0.1}, 30}, {{-6, -35, 0}, 200}});
  Cases cases;
  addPoses(cases, scene);
  addEffects(cases, scene);
  cases.add("points", "linear", withPoints, onSkin(), [](auto& s) { s.looks = 2; });
  addDisplaced(cases, withPoints, Look::Coherent);
  addNeedles(cases, scene);
  addLung(cases);
  addThesis(cases, thesisScene);
  addDisplaced(cases, thesisScene, Look::Thesis);
  const ScenePtr inside =
      sceneOf(paint(gridOver({-26, -56, -8}, {26, -18, 8}, 1.4), [](Vec3 p) { return p.y < -36 ? kBone : kMuscle; }),
              variedTable(), region);
  cases.add("no outside", "linear", inside, onSkin(10), kAsItIs);
  const ScenePtr overGas =
      sceneOf(paint(gridOver({-26, -56, -8}, {26, -18, 8}, 0.7), [](Vec3 p) { return p.y < -46 ? kMuscle : kAirway; }),
              variedTable(), region);
  // The central plane begins beyond the volume's end, another within it.
  Transform atTheEnd;
  atTheEnd.linear = {{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}};
  atTheEnd.offset = {0, -50, 8.6};
  cases.add("gas beyond the end", "linear", overGas, atTheEnd * turned({1, 0, 0}, -10), kAsItIs);
  for (const Label label : {kMuscle, kBackground}) {
    cases.add("one tissue", "linear", evenBlock(label), onSkin(10), kAsItIs);
    cases.add("thesis, one tissue", "linear", evenBlock(label), onSkin(10), [](auto& s) { s.look = Look::Thesis; });
  }
  return cases.all;
}

}  // namespace insonate::test
