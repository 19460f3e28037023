#include "LevelWindow.h"
#include "image/EffectWords.h"
#include "model/Disclosure.h"
#include "patient3d/PatientViews.h"

#include <insonate/simulator/EffectLayers.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Text.h>

#include <ui/support/VisibleTexts.h>

#include <QRegularExpression>
#include <map>

namespace insonate::train {
namespace {

/// An attempt of a level, in the tissue, through the vein, in an artery and out, with everything tried that would show
/// more than the image; and everything that the screen says meanwhile.
class TrainDisclosure : public LevelWindow {
 protected:
  Curriculum curriculum() const override {
    Curriculum all = LevelWindow::curriculum();
    all.levels.resize(1);
    all.levels.front().assistance = assistance_;
    return all;
  }
  static PatientCase namedCase() {
    PatientCase named = wideCase();
    named.manifest.targets = {{"right internal jugular vein", kVein, {0, 12, 0}}};
    named.manifest.vessels = {{"right internal jugular vein", kVein, {{{0, 12, -25}, 4.5}, {{0, 12, 25}, 4.5}}},
                              {"right common carotid artery", kArtery, {{{40, 12, -25}, 2.5}, {{40, 12, 25}, 2.5}}}};
    return named;
  }

  /// Patterns of words that tell more than the image, by their kind.
  std::map<QString, QRegularExpression> forbidden() const {
    std::map<QString, QRegularExpression> all;
    const auto add = [&](const QString& words) {
      all.insert({words, QRegularExpression("\\b" + QRegularExpression::escape(words) + "s?\\b",
                                            QRegularExpression::CaseInsensitiveOption |
                                                QRegularExpression::UseUnicodePropertiesOption)});
    };
    for (const LabelInfo& info : labelTable())
      if (info.label != kBackground && info.label != kSkin) add(ui::qt(info.name));
    const CaseManifest& manifest = model_->patientCase.patient()->manifest;
    for (const NamedVessel& vessel : manifest.vessels) {
      add(ui::qt(vessel.name));
      for (const QString& word : ui::qt(vessel.name).split(' ')) add(word);
    }
    for (const StartPose& pose : manifest.startPoses) add(ui::qt(pose.name));
    for (const NeedlePlace place : {NeedlePlace::Vein, NeedlePlace::WrongPlace}) add(ui::displayText(place).words);
    for (const EffectLayer& layer : effectLayers(model_->imaging.settings())) add("only " + effectWords(layer.name));
    for (const char* words : {"airway", "lung", "cartilage", "in soft tissue", "on bone", "posterior wall", "puncture"})
      add(words);
    // "right" is a side, too.
    all.erase("right");
    all.insert({"a percentage", QRegularExpression("\\d\\s*(%|percent)")});
    all.insert({"an area", QRegularExpression("\\d\\s*(mm²|cm²|square)")});
    return all;
  }

  void look(const char* moment) {
    QTest::qWait(250);  // slower than the strip's numbers
    std::vector<test::VisibleText> texts = test::visibleTexts(*workspace_);
    texts.push_back({"status line", workspace_->statusText()});
    texts.push_back({"engine", workspace_->engineText() + ' ' + workspace_->engineNote()});
    for (const QString& sentence : std::exchange(said_, {})) texts.push_back({"said", sentence});
    for (const QAction* action : workspace_->actions())
      texts.push_back({"View menu", action->text() + ' ' + action->toolTip()});
    seen_ += int(texts.size());
    const auto words = forbidden();
    for (const test::VisibleText& one : texts)
      for (const auto& [what, expression] : words)
        if (expression.match(one.text).hasMatch())
          found_[what] << QString("%1: %2: %3").arg(moment, one.where, one.text);
  }

  /// Each key and choice that shows more, and back.
  void tryEverything(const char* moment) {
    for (const Qt::Key one : {Qt::Key_T, Qt::Key_P, Qt::Key_K, Qt::Key_C, Qt::Key_X, Qt::Key_H, Qt::Key_N, Qt::Key_1}) {
      key(one);
      look(moment);
      if (one == Qt::Key_N) key(Qt::Key_0);
    }
    for (const Qt::Key one : {Qt::Key_H, Qt::Key_X, Qt::Key_C, Qt::Key_T, Qt::Key_P}) key(one);
  }

  void drive(NeedlePlace place, const char* length) {
    type("needle_depth", length);
    ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == place; }))
        << length << ": " << lying().depth_mm << " mm, entry at " << held().entry_mm.x << ", angle " << held().angle_deg
        << ", " << workspace_->statusText().toStdString();
  }

  void makeWholeAttempt() {
    signIn();
    open(std::make_shared<const PatientCase>(namedCase()));
    levels_->choose("first");
    ASSERT_TRUE(levels_->level() && !levels_->waitsForCase());
    key(Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return attempt_->isRunning(); })) << workspace_->statusText().toStdString();
    look("begun");
    model_->motion.moveTo({0, 0, 0});
    model_->motion.typed(HandAxis::Press, 3);
    ASSERT_TRUE(waitFor([&] {
      const LiveDeformation& press = model_->live.shown()->press;
      return press.force_N > 0.1 && !press.lumens.empty();
    }));
    look("compressed");
    tryEverything("compressed");
    model_->motion.typed(HandAxis::Press, 0);
    overTheVein();
    drive(NeedlePlace::UnderSkin, "5");
    look("in tissue");
    drive(NeedlePlace::Vein, "12");
    key(Qt::Key_B);
    look("in the vein");
    tryEverything("in the vein");
    drive(NeedlePlace::WrongPlace, "22");
    look("behind it");
    drive(NeedlePlace::Used, "-5");
    hands().needleTo({40, 0, 12});
    type("needle_angle", "90");
    drive(NeedlePlace::WrongPlace, "13");
    look("in the artery");
    type("needle_depth", "40");
    ASSERT_TRUE(waitFor([&] { return lying().onBone; }));
    look("on bone");
    drive(NeedlePlace::Used, "-5");
    look("out");
  }
  std::string foundWords() const {
    QStringList all;
    for (const auto& [what, where] : found_) all << what + "\n    " + where.mid(0, 4).join("\n    ");
    return all.join('\n').toStdString();
  }

  Assistance assistance_ = Assistance::Test;
  std::map<QString, QStringList> found_;  ///< what was told, and where
  int seen_ = 0;
};

class TrainTest : public TrainDisclosure {};

TEST_F(TrainTest, TellsNothingThatTheImageDoesNotTell) {
  makeWholeAttempt();
  EXPECT_GT(seen_, 5000);
  EXPECT_TRUE(found_.empty()) << foundWords();

  EXPECT_EQ(model_->imaging.effect(), ImagingModel::kWholeModel);
  EXPECT_TRUE(model_->live.shown()->press.mesh.nodes.empty()) << "grid and pressure";
  auto* views = static_cast<PatientViews*>(child<ui::ViewWidget>("sceneView")->parentWidget()->parentWidget());
  for (const LabelInfo& info : labelTable())
    EXPECT_EQ(views->scene().isVisible(info.label), info.label == kSkin) << info.name;
  EXPECT_EQ(views->scene().opacity(kSkin), 1);
  EXPECT_FALSE(views->scene().isCtVisible());
  EXPECT_EQ(views->scene().clipping(), views::Clipping{});
  EXPECT_FALSE(views->mprWidget().isVisible());
  EXPECT_FALSE(child<ui::ViewWidget>("ctBeside")->isVisible());
  EXPECT_TRUE(text("attemptDrawn").contains("blood")) << "the syringe is seen by the patient, too";
  EXPECT_TRUE(workspace_->workspaceChangeBlocker().contains("A test is in progress")) << "Prepare shows the labels";

  found_.clear();
  finish();
  EXPECT_EQ(workspace_->workspaceChangeBlocker(), "");
  look("over");
  EXPECT_FALSE(found_.empty()) << "its end tells everything";
  EXPECT_TRUE(views->scene().isVisible(kVein));
}

TEST_F(TrainTest, BeginsWithTheWholeImageAndNoWayBackToAnEffect) {
  signIn();
  open(std::make_shared<const PatientCase>(namedCase()));
  key(Qt::Key_N);
  ASSERT_NE(model_->imaging.effect(), ImagingModel::kWholeModel);
  levels_->choose("first");
  key(Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return attempt_->isRunning(); }));
  EXPECT_EQ(model_->imaging.effect(), ImagingModel::kWholeModel);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(model_->imaging.effect(), ImagingModel::kWholeModel);
}

class TrainPractice : public TrainDisclosure {
 protected:
  TrainPractice() { assistance_ = Assistance::Guided; }
};

/// Shows that the test above can fail.
TEST_F(TrainPractice, TellsWhatATestDoesNot) {
  makeWholeAttempt();
  EXPECT_EQ(workspace_->workspaceChangeBlocker(), "") << "practice may look things up";
  for (const char* words : {"vein", "artery", "bone", "right internal jugular vein", "right common carotid artery",
                            "wrong place", "in the vein", "posterior wall", "a percentage", "an area"})
    EXPECT_TRUE(found_.count(words)) << words << "\n" << foundWords();
}

}  // namespace
}  // namespace insonate::train
