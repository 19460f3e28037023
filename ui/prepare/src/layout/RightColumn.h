#pragma once

#include <QSplitter>
#include <memory>
#include <vector>

class QScrollArea;
class QSettings;
class QTabBar;

namespace insonate::ui {
class ScenePanel;
}
namespace insonate::views {
class SceneView;
}

namespace insonate::prepare {

struct PrepareModel;
class Section;
class ToolSession;
class UltrasoundPane;

/// The column beside the slices: the selected tool, two pages of which one is shown, and the ultrasound image of the
/// labels. The first page is about the structures, the second about the check: findings, difficulty and places.
class RightColumn : public QSplitter {
  Q_OBJECT

 public:
  RightColumn(PrepareModel& shared, ToolSession& tools, std::shared_ptr<views::SceneView> scene,
              QWidget* parent = nullptr);

  ui::ScenePanel& scene() { return *scene_; }
  UltrasoundPane& ultrasound() { return *ultrasound_; }
  bool showsCheck() const;
  void setCheckShown(bool shown);
  /// Shows or hides the section of the selected tool, expands it, and scrolls to the top of the column.
  void setToolShown(bool shown);
  void setToolRemark(const QString& remark);
  void setCheckRemark(const QString& remark);
  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 Q_SIGNALS:
  /// Emitted when the user wants to make a structure that the check misses.
  void labelWanted(int label);
  /// Emitted when the user has chosen what to mark; the next click sets its position.
  void markingBegun();

 private:
  QWidget* buildPage(const std::vector<Section*>& sections);
  std::vector<Section*> buildCheck(PrepareModel& shared);
  void showPage();

  QTabBar* tabs_;
  QScrollArea* scroll_;
  QWidget *look_ = nullptr, *checkPage_ = nullptr;
  Section *tool_ = nullptr, *check_ = nullptr;
  std::vector<Section*> all_;
  ui::ScenePanel* scene_;
  UltrasoundPane* ultrasound_;
};

}  // namespace insonate::prepare
