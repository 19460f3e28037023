#pragma once

#include <insonate/views/SceneView.h>

#include <QWidget>
#include <cstdint>
#include <memory>
#include <vector>

class QLabel;
class QSpinBox;
class QToolButton;
class QVBoxLayout;

namespace insonate::ui {

/// Table with one row for each surface of a scene: visibility, color, name, opacity.
class StructureList : public QWidget {
  Q_OBJECT

 public:
  explicit StructureList(std::shared_ptr<views::SceneView> scene, QWidget* parent = nullptr);

  /// Updates the rows from the scene.
  void refresh();

 Q_SIGNALS:
  void changed();       ///< emitted when the user changes a structure
  void colorChanged();  ///< emitted when the user changes a color

 private:
  struct Row {
    std::uint8_t label;
    QWidget* widget;
    QToolButton *eye, *color;
    QSpinBox* opacity;
  };
  void rebuild(const std::vector<std::uint8_t>& labels);
  Row makeRow(std::uint8_t label);
  void chooseColor(std::uint8_t label);

  std::shared_ptr<views::SceneView> scene_;
  QVBoxLayout* box_;
  QLabel* empty_;
  std::vector<Row> rows_;
  bool refreshing_ = false;
};

}  // namespace insonate::ui
