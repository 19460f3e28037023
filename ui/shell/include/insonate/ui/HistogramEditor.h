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

/// Editor of the transfer function of a CT, drawn over the histogram of the CT. Each node of the function has a
/// Hounsfield value, an opacity and a color. The user drags nodes, adds a node by a double click, and removes a node by
/// Delete or a right click. Tab selects the next node, arrow keys move the selected node, and its numbers can be typed.
/// The editor has presets, undo, redo and reset. May be used only on the window's thread.
class HistogramEditor : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramEditor(QWidget* parent = nullptr);
  ~HistogramEditor() override;

  /// Sets the case; null: no case. A background thread computes its histogram, which appears later.
  void setCase(std::shared_ptr<const PatientCase> patient);
  /// Returns the histogram of the case; empty until it has been computed.
  const views::HuHistogram& histogram() const;
  /// Sets the display window of CT slices, which is drawn as a band; empty: no band.
  void setWindowLevel(std::optional<views::WindowLevel> window);

  const views::TransferFunction& function() const;
  /// Sets the function, corrected by views::sortedAndClamped(). Clears the undo stack. Emits functionChanged() if the
  /// function differs from the present one.
  void setFunction(const views::TransferFunction& function);
  /// Applies the preset with this name in views::transferPresets(), as one undo step. Ignores unknown names.
  void choosePreset(const QString& name);
  /// Restores the preset that was chosen last.
  void reset();

  /// Returns the index of the selected node; -1 if no node is selected.
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
  void chooseColor();
  void refresh();

  HistogramPlot* plot_;
  QUndoStack* undo_;
  QComboBox* preset_ = nullptr;
  QLabel* which_ = nullptr;
  QSpinBox* hu_ = nullptr;
  QDoubleSpinBox* opacity_ = nullptr;
  QToolButton* color_ = nullptr;
  QToolButton* remove_ = nullptr;
  QToolButton* add_ = nullptr;
  int presetIndex_ = 0;
  bool refreshing_ = false;
  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<std::atomic<bool>> stop_;
  QFutureWatcher<views::HuHistogram> counting_;
};

}  // namespace insonate::ui
