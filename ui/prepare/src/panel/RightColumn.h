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

/// The column beside the slices: the tool in hand, two pages of which one is shown, and the ultrasound of the labels.
/// The first page is about the structures, the second is the check: findings, difficulty and places.
class RightColumn : public QSplitter {
  Q_OBJECT

 public:
  RightColumn(PrepareModel& shared, ToolSession& tools, std::shared_ptr<views::SceneView> scene,
              QWidget* parent = nullptr);

  ui::ScenePanel& scene() { return *scene_; }
  UltrasoundPane& ultrasound() { return *ultrasound_; }
  bool showsCheck() const;
  void setCheckShown(bool shown);
  /// The tool in hand is seen at once, or is gone.
  void setToolShown(bool shown);
  void setToolRemark(const QString& remark);
  void setCheckRemark(const QString& remark);
  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 Q_SIGNALS:
  /// A structure that the check misses is to be made.
  void labelWanted(int label);
  /// It is chosen what to mark: the next click says where.
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
