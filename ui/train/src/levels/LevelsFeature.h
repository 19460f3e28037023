#pragma once

#include "../feature/Feature.h"

#include <insonate/curriculum/AttemptFacts.h>

#include <optional>

class QAction;

namespace insonate::train {

class AttemptControl;
class AttemptSaver;
class AttemptPanel;
class Course;
class CoursePage;
class LevelControl;
class TestAdmissions;
class VerdictView;

/// The feature for levels, the user's attempts and the questionnaire: the level in the attempt panel, the verdict
/// beside the result, and the page in place of the columns.
class LevelsFeature final : public Feature {
  Q_OBJECT

 public:
  LevelsFeature(TrainModel& model, TrainLayout& layout, AttemptControl& attempt, AttemptPanel& panel);
  ~LevelsFeature() override;

  void setAccount(ui::Account& account) override;
  bool holdsCase() const override;

 private:
  void addCommands();
  void fillPanel();
  void connectParts();
  void judge(const AttemptFacts& facts);
  void judgeAgain();
  void makePage();
  void showPage(bool isShown);

  AttemptControl& attempt_;
  AttemptPanel& panel_;
  QAction* pageAction_ = nullptr;
  Course* course_;
  TestAdmissions* admissions_;
  LevelControl* levels_;
  AttemptSaver* keeper_;
  VerdictView* verdict_ = nullptr;
  std::optional<AttemptFacts> judged_;  ///< facts of the attempt whose verdict is shown, as they were judged
  CoursePage* page_ = nullptr;          ///< the page; null until it is first shown
  ui::Account* account_ = nullptr;
};

}  // namespace insonate::train
