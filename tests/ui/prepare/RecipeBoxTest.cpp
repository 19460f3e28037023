#include "ToolsWindow.h"

#include <insonate/segmentation/Recipe.h>

#include <QFileDialog>
#include <QListWidget>
#include <QTemporaryDir>
#include <fstream>

namespace insonate::prepare {
namespace {

/// Steps that were done, saved to a file and replayed, by the buttons and their dialogs.
class RecipeWindow : public Tools {
 protected:
  void choose(const char* buttonName, const char* dialogName, const QString& file) {
    child<QPushButton>(buttonName)->click();
    auto* dialog = child<QFileDialog>(dialogName);
    ASSERT_TRUE(dialog);
    dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(file);
    QMetaObject::invokeMethod(dialog, "accept", Qt::DirectConnection);
    QApplication::processEvents();
  }
  QString file(const char* name) const { return folder_.filePath(QLatin1String(name)); }
  bool replayed() {
    return QTest::qWaitFor(
        [&] { return !shared_->labeling.isBusy() && child<QPushButton>("recipeReplay")->isEnabled(); }, kPatience_ms);
  }
  QTemporaryDir folder_;
};

TEST_F(RecipeWindow, StepsAreListedSavedAndReplayedToTheSameVoxels) {
  EXPECT_FALSE(child<QPushButton>("recipeSave")->isEnabled()) << "nothing was done";
  shared_->structures.add(kArtery);
  key(Qt::Key_1);
  drag({-14, 12, 0}, {-8, 14, 0});
  child<QAction>("tool-margin")->trigger();
  child<QPushButton>("toolApply")->click();
  ASSERT_TRUE(done());
  EXPECT_EQ(child<QListWidget>("recipeSteps")->count(), 2);
  EXPECT_TRUE(child<QListWidget>("recipeSteps")->item(1)->text().contains("margin: artery"));
  const auto made = labels().voxels;
  choose("recipeSave", "recipeSaveDialog", file("steps.json"));
  ASSERT_TRUE(loadRecipe(file("steps.json").toStdString()));
  shared_->openCase.undoStack().undo();
  shared_->openCase.undoStack().undo();
  ASSERT_EQ(labels().voxels, patient()->labels.voxels);
  choose("recipeReplay", "recipeReplayDialog", file("steps.json"));
  ASSERT_TRUE(replayed());
  EXPECT_EQ(labels().voxels, made);
  shared_->openCase.undoStack().undo();
  shared_->openCase.undoStack().undo();
  EXPECT_EQ(labels().voxels, patient()->labels.voxels);
}

TEST_F(RecipeWindow, AStepThatCannotBeDoneLeavesTheLabelsAsTheyWere) {
  Recipe recipe;
  LabelStep good, bad;
  good.label = kArtery, good.tool = step::Paint{{{0, 20, 0}}, 3};
  bad.label = kArtery, bad.tool = step::Connected{{{0, 0, 900}}, {0, 100}};
  recipe.steps = {good, bad};
  std::ofstream(file("bad.json").toStdString()) << textOf(recipe);
  choose("recipeReplay", "recipeReplayDialog", file("bad.json"));
  ASSERT_TRUE(replayed());
  EXPECT_EQ(labels().voxels, patient()->labels.voxels);
  EXPECT_TRUE(workspace_->statusText().contains("the labels are unchanged")) << workspace_->statusText().toStdString();
}

TEST_F(RecipeWindow, ACancelLeavesTheLabelsAsTheyWere) {
  Recipe recipe;
  recipe.labels = {{kLabelCount, {"port", kBone}}};
  LabelStep paint;
  paint.label = kLabelCount, paint.tool = step::Paint{{{0, 20, 0}}, 3};
  recipe.steps.assign(200, paint);
  for (std::size_t n = 0; n < recipe.steps.size(); ++n)
    std::get<step::Paint>(recipe.steps[n].tool).points_mm[0].x = double(n) / 20;
  std::ofstream(file("long.json").toStdString()) << textOf(recipe);
  choose("recipeReplay", "recipeReplayDialog", file("long.json"));
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return labels().voxels != patient()->labels.voxels && tasks_.isRunning(); }, kPatience_ms));
  tasks_.cancel();
  ASSERT_TRUE(replayed());
  EXPECT_EQ(labels().voxels, patient()->labels.voxels);
  EXPECT_TRUE(shared_->terms.value().own.empty()) << "nor are its names";
  EXPECT_TRUE(workspace_->statusText().contains("the labels are unchanged")) << workspace_->statusText().toStdString();
}

TEST_F(RecipeWindow, NamesOfItsLabelsComeWithARecipe) {
  Recipe recipe;
  recipe.labels = {{kLabelCount, {"port", kBone}}};
  LabelStep paint;
  paint.label = kLabelCount, paint.tool = step::Paint{{{0, 20, 0}}, 3};
  recipe.steps = {paint};
  std::ofstream(file("port.json").toStdString()) << textOf(recipe);
  choose("recipeReplay", "recipeReplayDialog", file("port.json"));
  ASSERT_TRUE(replayed());
  EXPECT_EQ(shared_->terms.value().own, recipe.labels);
  EXPECT_TRUE(child<QListWidget>("recipeSteps")->item(0)->text().contains("port"));
  choose("recipeSave", "recipeSaveDialog", file("again.json"));
  EXPECT_EQ(loadRecipe(file("again.json").toStdString())->labels, recipe.labels);
}

TEST_F(RecipeWindow, AFileThatIsNoRecipeGivesASentence) {
  std::ofstream(file("no.json").toStdString()) << "{\"steps\": [{\"tool\": \"nosuch\"}]}";
  choose("recipeReplay", "recipeReplayDialog", file("no.json"));
  EXPECT_TRUE(workspace_->statusText().contains("nosuch")) << workspace_->statusText().toStdString();
  EXPECT_EQ(labels().voxels, patient()->labels.voxels);
}

}  // namespace
}  // namespace insonate::prepare
