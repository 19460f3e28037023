#pragma once

#include <insonate/curriculum/CurriculumDraft.h>

#include <QFrame>
#include <string>
#include <vector>

class QLabel;

namespace insonate::ui {

/// Shows why a curriculum cannot be published, and the texts that a trainee would read at each stage of
/// one of its levels.
class LevelSituationsView final : public QFrame {
  Q_OBJECT

 public:
  explicit LevelSituationsView(QWidget* parent = nullptr);

  void show(const Curriculum& curriculum, const std::string& level, const std::vector<DraftError>& errors);
  using QWidget::show;

 private:
  QLabel *errors_, *heading_, *story_;
};

}  // namespace insonate::ui
