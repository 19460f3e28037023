#include "Waiting.h"

#include <insonate/ui/MainWindow.h>
#include <insonate/ui/Sound.h>
#include <insonate/ui/SoundMixer.h>

#include <gtest/gtest.h>

#include <QAction>
#include <algorithm>
#include <cmath>
#include <vector>

namespace insonate::ui {
namespace {

std::vector<float> mixed(SoundMixer& mixer, std::size_t count) {
  std::vector<float> out(count, 9.0F);
  mixer.mix(out);
  return out;
}

std::size_t samplesIn(double seconds) {
  return std::size_t(std::lround(seconds * kSoundRate_Hz));
}

TEST(SoundMixer, IsSilentWithoutSources) {
  SoundMixer mixer;
  EXPECT_EQ(mixed(mixer, 100), std::vector<float>(100, 0.0F));
}

TEST(SoundMixer, PlaysABeepOnceAcrossReads) {
  SoundMixer mixer;
  mixer.play(std::vector<float>{0.1F, 0.2F, 0.3F});
  EXPECT_EQ(mixed(mixer, 2), (std::vector<float>{0.1F, 0.2F}));
  EXPECT_EQ(mixed(mixer, 3), (std::vector<float>{0.3F, 0, 0}));
}

TEST(SoundMixer, AddsBeepsAndStreams) {
  SoundMixer mixer;
  const auto stream = mixer.openStream();
  stream->append(std::vector<float>(samplesIn(0.2), 0.2F));
  mixed(mixer, samplesIn(0.01));
  mixer.play(std::vector<float>(100, 0.3F));
  const std::vector<float> out = mixed(mixer, 200);
  EXPECT_NEAR(out[50], 0.5, 1e-6);
  EXPECT_NEAR(out[150], 0.2, 1e-6);
}

TEST(SoundMixer, LimitsLoudSoundsWithoutClipping) {
  SoundMixer mixer;
  for (int i = 0; i < 4; ++i) mixer.play(std::vector<float>(10, 0.9F));
  const float loud = mixed(mixer, 10)[5];
  EXPECT_GT(loud, 0.9F);
  EXPECT_LE(loud, 1.0F);
}

TEST(SoundMixer, KeepsFewBeepsWhileNoDeviceReads) {
  SoundMixer mixer;
  for (int i = 0; i < 1000; ++i) mixer.play(std::vector<float>(10, 0.01F));
  EXPECT_NEAR(mixed(mixer, 1)[0], 0.08, 1e-5);
}

TEST(SoundStream, BeginsWithItsLeadAndWithoutAClick) {
  SoundMixer mixer;
  const auto stream = mixer.openStream();
  stream->append(std::vector<float>(samplesIn(SoundStream::kLead_s) - 1, 0.5F));
  EXPECT_EQ(mixed(mixer, 10), std::vector<float>(10, 0.0F));
  stream->append(std::vector<float>(1, 0.5F));
  const std::vector<float> out = mixed(mixer, samplesIn(0.02));
  EXPECT_EQ(out[0], 0.0F);
  EXPECT_NEAR(out.back(), 0.5, 1e-6);
  for (std::size_t i = 1; i < out.size(); ++i) EXPECT_LT(std::abs(out[i] - out[i - 1]), 0.01F);
}

TEST(SoundStream, FadesOutWhenItsSourceIsLate) {
  SoundMixer mixer;
  const auto stream = mixer.openStream();
  stream->append(std::vector<float>(samplesIn(0.1), 0.5F));
  const std::vector<float> out = mixed(mixer, samplesIn(0.2));
  for (std::size_t i = 1; i < out.size(); ++i) EXPECT_LT(std::abs(out[i] - out[i - 1]), 0.01F);
  EXPECT_EQ(out.back(), 0.0F);
  // It begins again with the lead.
  stream->append(std::vector<float>(10, 0.5F));
  EXPECT_EQ(mixed(mixer, 10), std::vector<float>(10, 0.0F));
}

TEST(SoundStream, NeverFallsBehind) {
  SoundStream stream;
  for (int i = 0; i < 100; ++i) stream.append(std::vector<float>(samplesIn(0.1), i == 99 ? 0.5F : 0.1F));
  std::vector<float> out(samplesIn(SoundStream::kMost_s), 0.0F);
  stream.addTo(out);
  EXPECT_EQ(out.back(), 0.0F);
  EXPECT_NEAR(out[samplesIn(SoundStream::kLead_s) / 2], 0.5, 1e-6) << "the latest samples are kept";
}

TEST(SoundStream, EndsWithItsOwner) {
  SoundMixer mixer;
  auto stream = mixer.openStream();
  stream->append(std::vector<float>(samplesIn(0.2), 0.5F));
  stream = nullptr;
  EXPECT_EQ(mixed(mixer, 1000), std::vector<float>(1000, 0.0F));
}

TEST(Sound, IsOffAtFirstAndRemembered) {
  {
    Sound sound;
    EXPECT_FALSE(sound.isOn());
    sound.setOn(true);
  }
  Sound next;
  EXPECT_TRUE(next.isOn());
  next.setOn(false);
  EXPECT_FALSE(Sound().isOn());
}

/// Computers for tests have no sound device; with one, the sound plays and there is no problem to show.
TEST(Sound, ToolTipTellsThatThereIsNoDevice) {
  MainWindow window;
  QAction* action = window.commands().action("window.frame.sound");
  ASSERT_NE(action, nullptr);
  EXPECT_FALSE(action->isChecked());
  const QString before = action->toolTip();
  action->trigger();
  EXPECT_TRUE(action->isChecked());
  test::waitUntil([&] { return action->toolTip() != before; }, 3000);
  if (action->toolTip() != before) {
    EXPECT_TRUE(action->toolTip().contains("sound device")) << action->toolTip().toStdString();
  }
  action->trigger();
  EXPECT_FALSE(action->isChecked());
  EXPECT_EQ(action->toolTip(), before);
  window.closeAtOnce();
}

}  // namespace
}  // namespace insonate::ui
