#pragma once

#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace insonate::ui {
class Commands;
}
namespace insonate::views {
struct HuHistogram;
}

namespace insonate::prepare {

class LabelBox;
struct PrepareModel;
class RangeField;
class RulesBox;
class ToolSession;
struct ToolChoice;
struct ToolNumber;

/// Shows the selected tool: instructions, parameters, and buttons for preview and for applying the tool.
class ToolPanel : public QWidget {
 public:
  /// `commands`: their keys appear in tooltips.
  ToolPanel(PrepareModel& shared, ToolSession& tools, const ui::Commands& commands);
  ~ToolPanel() override;

  /// Sets the histogram of the case's CT.
  void setHistogram(const views::HuHistogram& histogram);

 private:
  void arrange();
  void build();
  void addNumber(QVBoxLayout& box, const ToolNumber& number);
  void addChoice(QVBoxLayout& box, const ToolChoice& choice);
  void addRange(QVBoxLayout& box);
  void addOther(QVBoxLayout& box);
  void refresh();
  void showComputing();

  PrepareModel& shared_;
  ToolSession& tools_;
  const QString applies_, leaves_;  ///< tooltips of the buttons
  QLabel *name_, *advice_;
  /// Shows the reason why a step had no result. The reason is shown here in full, since the status bar shares its space
  /// with jobs.
  QLabel* told_;
  LabelBox* label_;
  RulesBox* rules_;
  RangeField* range_ = nullptr;  ///< range of the selected tool; null if it has none
  std::unique_ptr<views::HuHistogram> histogram_;
  QPushButton *preview_, *apply_, *leave_;
  QWidget* fields_ = nullptr;
  QVBoxLayout* box_;
  std::vector<std::function<void()>> shown_;  ///< functions that update the fields
  QTimer slow_;                               ///< runs while a preview is computed; when the timer ends, the panel
                                              ///< shows that the preview takes long
  bool showing_ = false;
};

}  // namespace insonate::prepare
