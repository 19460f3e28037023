#pragma once

#include <QWidget>
#include <vector>

class QToolButton;

namespace insonate::ui {
class Commands;
}

namespace insonate::prepare {

class ToolSession;

/// The palette: one button for each tool or group of tools. The button of a group opens a menu. The selected tool is
/// marked. If there is not enough space for all names, only icons are shown.
class ToolBar : public QWidget {
 public:
  /// `commands`: their keys appear in tooltips.
  ToolBar(ToolSession& tools, const ui::Commands& commands);
  /// The width is 0, since names are hidden first: the palette does not take space from the views.
  QSize minimumSizeHint() const override { return {0, QWidget::minimumSizeHint().height()}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QToolButton* add(const QString& id, const QString& name, const QString& tip);
  void refresh();

  ToolSession& tools_;
  struct Entry {
    QToolButton* button;
    QStringList ids;  ///< ids of the button's tools; empty for the crosshair
  };
  std::vector<Entry> entries_;
};

/// Returns the tool that a key selects: the first tool of the key's group or, if a tool of the group is selected, the
/// next tool of the group. Empty if the key has no tool.
QString toolOfKey(int key, const QString& inHand);

}  // namespace insonate::prepare
