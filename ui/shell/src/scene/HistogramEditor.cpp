#include "../controls/NumberBox.h"
#include "HistogramPlot.h"

#include <insonate/ui/HistogramEditor.h>
#include <insonate/ui/Theme.h>

#include <QAction>
#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <QToolButton>
#include <QToolTip>
#include <QUndoCommand>
#include <QUndoStack>
#include <QVBoxLayout>
#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>
#include <utility>

namespace insonate::ui {
namespace {

using Function = views::TransferFunction;
constexpr int kSwatch_px = 16, kNumber_px = 72;
enum Field { kHu, kOpacity };
/// Ids of the gestures of typing, apart from those of the plot.
constexpr int kTyping = 1'000'000;

QString nameOf(const views::TransferPreset& preset) {
  return HistogramEditor::tr(std::string(preset.name).c_str());
}

QToolButton* button(const QString& iconName, const QString& text, const QString& tip) {
  auto* made = new QToolButton;
  made->setToolTip(tip);
  made->setAccessibleName(text);
  if (iconName.isEmpty())
    made->setText(text);
  else
    made->setIcon(icon(iconName));
  return made;
}

}  // namespace

/// One undo step; the changes of one gesture are merged.
class HistogramEditor::Change final : public QUndoCommand {
 public:
  Change(HistogramEditor& editor, Function after, int gesture, const QString& what)
      : QUndoCommand(what), editor_(editor), before_(editor.function()), after_(std::move(after)), gesture_(gesture) {}
  void undo() override { editor_.apply(before_); }
  void redo() override { editor_.apply(after_); }
  int id() const override { return gesture_ == 0 ? -1 : 1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* later = static_cast<const Change*>(other);
    if (later->gesture_ != gesture_) return false;
    after_ = later->after_;
    return true;
  }

 private:
  HistogramEditor& editor_;
  Function before_, after_;
  int gesture_;
};

HistogramEditor::HistogramEditor(QWidget* parent)
    : QWidget(parent), plot_(new HistogramPlot), undo_(new QUndoStack(this)) {
  setObjectName(QStringLiteral("histogramEditor"));
  plot_->setObjectName(QStringLiteral("histogramPlot"));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(kSmallGap);
  box->addWidget(buildTop());
  box->addWidget(plot_);
  box->addWidget(buildNumbers());
  connect(plot_, &HistogramPlot::edited, this, &HistogramEditor::push);
  connect(plot_, &HistogramPlot::selectionChanged, this, &HistogramEditor::refresh);
  connect(plot_, &HistogramPlot::movingChanged, this, &HistogramEditor::movingChanged);
  connect(plot_, &HistogramPlot::colorRequested, this, &HistogramEditor::chooseColor);
  connect(&counting_, &QFutureWatcher<views::HuHistogram>::finished, this, [this] {
    plot_->setHistogram(counting_.future().resultCount() > 0 ? counting_.result() : views::HuHistogram{});
    Q_EMIT counted();
  });
  plot_->setFunction(views::transferPresets().front().function);
  refresh();
}

HistogramEditor::~HistogramEditor() {
  if (stop_) *stop_ = true;
}

QWidget* HistogramEditor::buildTop() {
  auto* row = new QWidget;
  auto* box = new QHBoxLayout(row);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(kSmallGap);
  preset_ = new QComboBox;
  preset_->setObjectName(QStringLiteral("transferPreset"));
  preset_->setAccessibleName(tr("Preset of the transfer function"));
  preset_->setToolTip(tr("Presets of the transfer function; to adjust the function, drag the points in the plot"));
  for (const auto& preset : views::transferPresets()) preset_->addItem(nameOf(preset));
  preset_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  preset_->setMinimumContentsLength(6);
  preset_->setPlaceholderText(tr("changed"));  // no preset is in use
  connect(preset_, qOverload<int>(&QComboBox::activated), this,
          [this](int index) { choosePreset(preset_->itemText(index)); });
  box->addWidget(preset_, 1);

  const auto undoable = [&](QAction* action, const char* iconName, QKeySequence::StandardKey keys) {
    action->setIcon(icon(QLatin1String(iconName)));
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    addAction(action);
    auto* made = new QToolButton;
    made->setDefaultAction(action);
    made->setObjectName(QLatin1String(iconName));
    box->addWidget(made);
  };
  undoable(undo_->createUndoAction(this, tr("Undo")), "undo", QKeySequence::Undo);
  undoable(undo_->createRedoAction(this, tr("Redo")), "redo", QKeySequence::Redo);
  auto* again = button({}, tr("Reset"), tr("Restores the chosen preset"));
  again->setObjectName(QStringLiteral("transferReset"));
  connect(again, &QToolButton::clicked, this, &HistogramEditor::reset);
  box->addWidget(again);
  return row;
}

QWidget* HistogramEditor::buildNumbers() {
  auto* row = new QWidget;
  auto* box = new QHBoxLayout(row);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(2);
  which_ = new QLabel;
  setRole(which_, "quiet");
  hu_ = new NumberBox<QSpinBox>(tr("Hounsfield units of the point"));
  hu_->setObjectName(QStringLiteral("nodeHu"));
  hu_->setRange(int(Function::kMin_HU), int(Function::kMax_HU));
  hu_->setSuffix(tr(" HU"));
  hu_->setSingleStep(10);
  hu_->setAccessibleName(tr("Hounsfield units of the point"));
  hu_->setToolTip(tr("Position of the point in Hounsfield units: air −1000, water 0, bone above 200"));
  opacity_ = new NumberBox<QDoubleSpinBox>(tr("Opacity of the point"));
  opacity_->setObjectName(QStringLiteral("nodeOpacity"));
  opacity_->setRange(0, 100);
  opacity_->setDecimals(1);
  opacity_->setSuffix(tr(" %"));
  opacity_->setAccessibleName(tr("Opacity of the point in %"));
  opacity_->setToolTip(tr("Opacity of one millimeter of tissue with the Hounsfield units of this point, in %"));
  for (QAbstractSpinBox* number : {static_cast<QAbstractSpinBox*>(hu_), static_cast<QAbstractSpinBox*>(opacity_)}) {
    number->setButtonSymbols(QAbstractSpinBox::NoButtons);
    number->setFixedWidth(kNumber_px);
    number->setKeyboardTracking(false);
  }
  color_ = button(QStringLiteral("eye"), tr("Color of the point"),
                  tr("Color of tissue with the Hounsfield units of this point"));
  color_->setObjectName(QStringLiteral("nodeColour"));
  add_ = button({}, QStringLiteral("+"), tr("Adds a point beside this one (Insert, or double click)"));
  add_->setAccessibleName(tr("Add a point"));
  remove_ = button(QStringLiteral("close"), tr("Remove the point"), tr("Remove this point (Delete, or right click)"));
  connect(hu_, qOverload<int>(&QSpinBox::valueChanged), this, [this] { typed(kHu); });
  connect(opacity_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { typed(kOpacity); });
  connect(color_, &QToolButton::clicked, this, &HistogramEditor::chooseColor);
  connect(add_, &QToolButton::clicked, plot_, &HistogramPlot::addBeside);
  connect(remove_, &QToolButton::clicked, plot_, &HistogramPlot::removeSelected);
  box->addWidget(which_, 1);
  for (QWidget* part : {static_cast<QWidget*>(hu_), static_cast<QWidget*>(opacity_), static_cast<QWidget*>(color_),
                        static_cast<QWidget*>(add_), static_cast<QWidget*>(remove_)})
    box->addWidget(part);
  return row;
}

void HistogramEditor::setCase(std::shared_ptr<const PatientCase> patient) {
  if (patient == patient_) return;
  if (stop_) *stop_ = true;
  patient_ = std::move(patient);
  plot_->setHistogram({});
  Q_EMIT counted();
  if (!patient_) return counting_.setFuture({});
  stop_ = std::make_shared<std::atomic<bool>>(false);
  counting_.setFuture(QtConcurrent::run(
      [counted = patient_, stop = stop_] { return views::huHistogram(counted->ct, 256, stop.get()); }));
}

const views::HuHistogram& HistogramEditor::histogram() const {
  return plot_->histogram();
}

void HistogramEditor::setWindowLevel(std::optional<views::WindowLevel> window) {
  plot_->setWindowLevel(window);
}

const Function& HistogramEditor::function() const {
  return plot_->function();
}

void HistogramEditor::setFunction(const Function& function) {
  const Function tidy = views::sortedAndClamped(function);
  if (tidy == this->function()) return;
  undo_->clear();
  apply(tidy);
}

void HistogramEditor::choosePreset(const QString& name) {
  const auto presets = views::transferPresets();
  for (std::size_t index = 0; index < presets.size(); ++index) {
    if (name != nameOf(presets[index])) continue;
    presetIndex_ = int(index);
    push(presets[index].function, 0, tr("preset change"));
  }
  refresh();
}

void HistogramEditor::reset() {
  choosePreset(nameOf(views::transferPresets()[std::size_t(presetIndex_)]));
}

int HistogramEditor::selected() const {
  return plot_->selected();
}

void HistogramEditor::select(int node) {
  plot_->select(node);
}

void HistogramEditor::push(const Function& wanted, int gesture, const QString& what) {
  const Function tidy = views::sortedAndClamped(wanted);
  if (tidy != function()) undo_->push(new Change(*this, tidy, gesture, what));
}

void HistogramEditor::apply(const Function& function) {
  plot_->setFunction(function);
  refresh();
  Q_EMIT functionChanged(function);
}

void HistogramEditor::typed(int field) {
  if (refreshing_ || selected() < 0) return;
  Function wanted = function();
  auto& nodes = wanted.nodes;
  const auto at = std::size_t(selected());
  if (field == kOpacity) {
    nodes[at].opacity = opacity_->value() / 100;
  } else {
    const double least = at > 0 ? nodes[at - 1].hu + Function::kMinGap_HU : Function::kMin_HU;
    const double most = at + 1 < nodes.size() ? nodes[at + 1].hu - Function::kMinGap_HU : Function::kMax_HU;
    nodes[at].hu = std::clamp<double>(hu_->value(), least, std::max(least, most));
    if (nodes[at].hu != hu_->value())
      QToolTip::showText(
          hu_->mapToGlobal({0, hu_->height()}),
          tr("A point must stay between its neighbors: this point can be from %1 to %2 HU.").arg(least).arg(most), hu_);
  }
  push(wanted, kTyping + 2 * selected() + field, tr("point value change"));
  refresh();
}

void HistogramEditor::chooseColor() {
  const int node = selected();
  if (node < 0) return;
  auto* dialog = new QColorDialog(toQColor(function().nodes[std::size_t(node)].color), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Color at %1 HU").arg(function().nodes[std::size_t(node)].hu));
  connect(dialog, &QColorDialog::colorSelected, this, [this, node](const QColor& chosen) {
    if (node >= int(function().nodes.size())) return;
    Function wanted = function();
    wanted.nodes[std::size_t(node)].color = {std::uint8_t(chosen.red()), std::uint8_t(chosen.green()),
                                             std::uint8_t(chosen.blue())};
    push(wanted, 0, tr("point color change"));
  });
  dialog->open();
}

void HistogramEditor::refresh() {
  refreshing_ = true;
  const auto presets = views::transferPresets();
  const auto same = std::find_if(presets.begin(), presets.end(),
                                 [this](const auto& preset) { return preset.function == function(); });
  preset_->setCurrentIndex(same == presets.end() ? -1 : int(same - presets.begin()));
  const auto& nodes = function().nodes;
  const bool any = selected() >= 0;
  which_->setText(any ? tr("%1 of %2").arg(selected() + 1).arg(nodes.size()) : tr("no point"));
  for (QWidget* part : {static_cast<QWidget*>(hu_), static_cast<QWidget*>(opacity_), static_cast<QWidget*>(color_)})
    part->setEnabled(any);
  remove_->setEnabled(any && nodes.size() > 1);
  if (any) {
    const auto& node = nodes[std::size_t(selected())];
    hu_->setValue(int(node.hu));
    opacity_->setValue(node.opacity * 100);
    QPixmap swatch(kSwatch_px, kSwatch_px);
    swatch.fill(toQColor(node.color));
    color_->setIcon(swatch);
  }
  refreshing_ = false;
}

}  // namespace insonate::ui
