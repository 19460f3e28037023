#include <insonate/simulator/EffectLayers.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace insonate {
namespace {

constexpr bool Effects::*kAll[]{
    &Effects::scattering, &Effects::reflection, &Effects::attenuation, &Effects::transmission,  &Effects::speckle,
    &Effects::layers,     &Effects::texture,    &Effects::beam,        &Effects::reverberation, &Effects::edgeShadow,
    &Effects::clutter,    &Effects::noise,      &Effects::nearField};

ImagingSettings withLook(Look look) {
  ImagingSettings settings;
  settings.look = look;
  settings.depth_mm = 55;
  return settings;
}

TEST(EffectLayers, CoherentShowsEveryEffectSomewhere) {
  const auto layers = effectLayers(withLook(Look::Coherent));
  for (const auto effect : kAll)
    EXPECT_TRUE(std::any_of(layers.begin(), layers.end(),
                            [&](const EffectLayer& layer) { return layer.settings.effects.*effect; }));
}

TEST(EffectLayers, ThesisHasItsFourLayers) {
  std::vector<std::string> names;
  for (const EffectLayer& layer : effectLayers(withLook(Look::Thesis))) names.push_back(layer.name);
  EXPECT_THAT(names, testing::UnorderedElementsAre("reflection", "absorption", "blur", "speckle"));
}

TEST(EffectLayers, DifferFromEachOtherAndOnlyInTheirEffects) {
  for (const Look look : {Look::Coherent, Look::Thesis}) {
    const ImagingSettings settings = withLook(look);
    std::set<std::string> names;
    std::set<std::vector<bool>> combinations;
    for (const EffectLayer& layer : effectLayers(settings)) {
      EXPECT_TRUE(names.insert(layer.name).second) << layer.name;
      std::vector<bool> combination;
      for (const auto effect : kAll) combination.push_back(layer.settings.effects.*effect);
      EXPECT_TRUE(combinations.insert(combination).second) << layer.name;
      EXPECT_EQ(layer.settings.look, settings.look);
      EXPECT_EQ(layer.settings.depth_mm, settings.depth_mm);
      EXPECT_FALSE(std::all_of(combination.begin(), combination.end(), [](bool on) { return on; })) << layer.name;
    }
  }
}

TEST(EffectLayers, EchogenicityIsScatteringAndNothingElse) {
  for (const EffectLayer& layer : effectLayers(withLook(Look::Coherent))) {
    if (layer.name != "echogenicity") continue;
    for (const auto effect : kAll) EXPECT_EQ(layer.settings.effects.*effect, effect == &Effects::scattering);
  }
}

}  // namespace
}  // namespace insonate
