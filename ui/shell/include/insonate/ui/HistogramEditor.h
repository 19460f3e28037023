#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/views/HuHistogram.h>
#include <insonate/views/TransferFunction.h>
#include <insonate/views/WindowLevel.h>

#include <QFutureWatcher>
#include <QWidget>
#include <atomic>
#include <memory>
#include <optional>

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;
class QToolButton;
class QUndoStack;

namespace insonate::ui {

class HistogramPlot;

/// Editor of a CT's transfer function on its histogram: each node has a Hounsfield value, opacity and color. Nodes are
/// dragged, added by double click, and removed by Delete or right click. Tab selects the next node, arrows move the
/// selected node, and its numbers can be typed. Has presets, undo, redo and reset. For the window's thread.
class HistogramEditor : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramEditor(QWidget* parent = nullptr);
  ~HistogramEditor() override;

  /// Sets the case; null: no case. Its histogram is counted on another thread and appears later.
  void setCase(std::shared_ptr<const PatientCase> patient);
  /// Histogram of the case; empty before it is counted.
  const views::HuHistogram& histogram() const;
  /// Sets the 8-bit display window, drawn as a band; empty: no band.
  void setWindowLevel(std::optional<views::WindowLevel> window);

  const views::TransferFunction& function() const;
  /// Sets the function after tidied(). Clears undo and redo. Emits functionChanged() if the function differs.
  void setFunction(const views::TransferFunction& function);
  /// Applies a preset by its name in views::transferPresets(), as one undoable step; unknown names are ignored.
  void choosePreset(const QString& name);
  /// Restores the preset that was chosen last.
  void reset();

  /// Number of the selected node, or -1.
  int selected() const;
  void select(int node);

  QUndoStack& undoStack() { return *undo_; }

 Q_SIGNALS:
  /// Emitted when histogram() has changed.
  void counted();
  /// Emitted after each change, also during a drag.
  void functionChanged(const insonate::views::TransferFunction& function);
  /// Emitted with true when the user begins to drag a node, and with false at the end.
  void movingChanged(bool moving);

 private:
  class Change;
  QWidget* buildTop();
  QWidget* buildNumbers();
  void push(const views::TransferFunction& function, int gesture, const QString& what);
  void apply(const views::TransferFunction& function);
  void typed(int field);
  void chooseColour();
  void refresh();

  HistogramPlot* plot_;
  QUndoStack* undo_;
  QComboBox* preset_ = nullptr;
  QLabel* which_ = nullptr;
  QSpinBox* hu_ = nullptr;
  QDoubleSpinBox* opacity_ = nullptr;
  QToolButton* colour_ = nullptr;
  QToolButton* remove_ = nullptr;
  QToolButton* add_ = nullptr;
  int presetIndex_ = 0;
  bool refreshing_ = false;
  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<std::atomic<bool>> stop_;
  QFutureWatcher<views::HuHistogram> counting_;
};

}  // namespace insonate::ui
