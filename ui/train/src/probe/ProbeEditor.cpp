#include "ProbeEditor.h"

#include "../model/ImagingModel.h"
#include "../model/StatusLine.h"
#include "ProbeLibrary.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::train {
namespace {

/// Presentation of a number of the probe. `heading` opens a group.
struct Presentation {
  const char* field;
  const char* heading;
  const char* name;
  const char* unit;
  const char* hint;
  double step;
  int decimals;
};
constexpr Presentation kNumbers[] = {
    {"width_mm", "Field of view", "width", "mm", "length of the array", 1, 1},
    {"fovAngle_deg", "", "angle", "\u00b0", "full angle of the fan (alpha)", 1, 1},
    {"faceRadius_mm", "", "face radius", "mm", "radius from the virtual apex to the probe face (r1)", 1, 1},
    {"defaultDepth_mm", "", "depth", "mm", "depth that the probe starts with (r2 minus r1)", 5, 1},
    {"minDepth_mm", "", "minimum depth", "mm", "smallest depth that can be chosen", 5, 0},
    {"maxDepth_mm", "", "maximum depth", "mm", "largest depth that can be chosen", 5, 0},
    {"defaultFocus_mm", "", "focus", "mm", "focus that the probe starts with", 1, 0},
    {"defaultFrequency_MHz", "Frequency", "frequency", "MHz", "frequency that the probe starts with", 0.5, 1},
    {"minFrequency_MHz", "", "minimum", "MHz", "lowest frequency that can be chosen", 0.5, 1},
    {"maxFrequency_MHz", "", "maximum", "MHz", "highest frequency that can be chosen", 0.5, 1},
    {"pitch_mm", "Array", "pitch", "mm", "distance of the elements, center to center", 0.01, 3},
    {"bandwidth", "", "bandwidth", "",
     "bandwidth of the received pulse at -6 dB, divided by its frequency; determines the axial resolution", 0.05, 2},
    {"transmitFNumber", "", "transmit F-number", "",
     "focus depth divided by aperture; determines the lateral resolution at the focus", 0.1, 1},
    {"receiveFNumber", "", "receive F-number", "",
     "depth divided by aperture; determines the lateral resolution at all depths", 0.1, 1},
    {"maxAperture_mm", "", "aperture", "mm", "largest active part of the array", 1, 0},
    {"faceMargin_mm", "", "face margin", "mm",
     "length by which the face that touches the skin extends beyond each end of the array", 0.5, 1},
    {"elementHeight_mm", "Slice", "element height", "mm",
     "element size perpendicular to the image plane; determines the slice thickness", 0.5, 1},
    {"elevationFocus_mm", "", "elevation focus", "mm", "focus of the lens, perpendicular to the image plane", 1, 0},
};

const ProbeField& fieldNamed(std::string_view name) {
  return *std::ranges::find(probeFields(), name, &ProbeField::name);
}

const char* presetOf(ProbeShape shape) {
  return shape == ProbeShape::Linear ? "linear" : shape == ProbeShape::Curvilinear ? "curvilinear" : "phased";
}

QPushButton* button(const QString& text, const char* object, const QString& tip) {
  return ui::pushButton(object, text, tip, Qt::TabFocus);
}

}  // namespace

ProbeEditor::ProbeEditor(StatusLine& status, ImagingModel& imaging, ProbeLibrary& library, QWidget* parent)
    : ScrollingColumn(parent), status_(status), imaging_(imaging), library_(library), draft_(imaging_.probe()) {
  setObjectName("probeEditor");
  auto* inner = new QWidget;
  auto* box = new QVBoxLayout(inner);
  box->setContentsMargins(12, 8, 12, 8);
  box->setSpacing(4);
  buildHead(*box);
  buildNumbers(*box);
  box->addStretch();
  setParts(inner, buildFoot());
  connect(&imaging_, &ImagingModel::setupChanged, this, [this] {
    if (!refreshing_) show(imaging_.probe());
  });
  connect(&library_, &ProbeLibrary::changed, this, &ProbeEditor::showButtons);
  show(imaging_.probe());
}

void ProbeEditor::buildHead(QVBoxLayout& box) {
  auto* title = new QLabel(tr("Edit probe"));
  ui::setRole(title, "heading");
  name_ = new QLineEdit;
  name_->setObjectName("probeName");
  name_->setAccessibleName(tr("Name of the probe"));
  name_->setToolTip(tr("Name of the probe in the list"));
  shape_ = new QComboBox;
  shape_->setObjectName("probeShape");
  shape_->addItems({tr("linear"), tr("curvilinear"), tr("phased")});
  shape_->setAccessibleName(tr("Shape of the probe"));
  shape_->setToolTip(tr("Shape of the field of view"));
  shape_->setFocusPolicy(Qt::TabFocus);
  apodization_ = new QComboBox;
  apodization_->setObjectName("apodization");
  apodization_->addItems({tr("uniform"), tr("Tukey"), tr("Hann")});
  apodization_->setAccessibleName(tr("Receive apodization"));
  apodization_->setToolTip(
      tr("Weights of the elements on receive, from the narrowest beam (uniform) to the lowest side lobes (Hann)"));
  apodization_->setFocusPolicy(Qt::TabFocus);
  auto* fit = button(tr("Fit probe geometry to an image ..."), "fitToPicture",
                     tr("Takes angle, radii and depth from a photograph or screen capture of a machine"));
  box.addWidget(title);
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  const auto row = [&](int at, const QString& text, QWidget* widget) {
    auto* label = new QLabel(text);
    ui::setRole(label, "quiet");
    grid->addWidget(label, at, 0);
    grid->addWidget(widget, at, 1);
  };
  row(0, tr("name"), name_);
  row(1, tr("shape"), shape_);
  row(2, tr("apodization"), apodization_);
  box.addLayout(grid);
  hint_ = new QLabel(tr("This probe is built in. Type another name to save your changes as a probe of your own."));
  hint_->setWordWrap(true);
  ui::setRole(hint_, "quiet");
  box.addWidget(hint_);
  box.addWidget(fit);
  connect(name_, &QLineEdit::editingFinished, this, &ProbeEditor::changeName);
  connect(shape_, qOverload<int>(&QComboBox::activated), this, &ProbeEditor::changeShape);
  connect(apodization_, qOverload<int>(&QComboBox::activated), this, [this](int weights) {
    draft_.apodization = Apodization(weights);
    use("apodization", nullptr);
  });
  // A click leaves the keyboard in the name: what was typed there counts.
  connect(fit, &QPushButton::clicked, this, [this] {
    changeName();
    Q_EMIT fitRequested();
  });
}

void ProbeEditor::buildNumbers(QVBoxLayout& box) {
  numbers_ = new QVBoxLayout;
  numbers_->setSpacing(4);
  for (const Presentation& shown : kNumbers) {
    const ProbeField& field = fieldNamed(shown.field);
    if (*shown.heading) {
      auto* heading = new QLabel(tr(shown.heading));
      ui::setRole(heading, "heading");
      numbers_->addSpacing(8);
      numbers_->addWidget(heading);
    }
    const ui::ValueRange range{field.low, field.high, draft_.*field.member, shown.step, shown.decimals};
    auto* slider = new ui::ValueSlider(tr(shown.name), QString::fromUtf8(shown.unit), range, tr(shown.hint));
    slider->setObjectName(shown.field);
    connect(slider, &ui::ValueSlider::valueChanged, this, [this, &field](double value) { changed(field, value); });
    rows_.push_back({&field, slider});
    numbers_->addWidget(slider);
  }
  problem_ = new QLabel;
  problem_->setObjectName("probeProblem");
  problem_->setWordWrap(true);
  problem_->setTextFormat(Qt::PlainText);
  ui::setRole(problem_, "problem");
  numbers_->insertWidget(0, problem_);
  box.addLayout(numbers_);
  problem_->hide();
}

QWidget* ProbeEditor::buildFoot() {
  auto* foot = new QWidget;
  auto* grid = new QGridLayout(foot);
  grid->setContentsMargins(12, 8, 12, 8);
  grid->setSpacing(4);
  save_ = button(tr("Save"), "saveProbe", tr("Saves this probe under its name, in a file for this user"));
  rename_ = button(tr("Rename"), "renameProbe", tr("Renames the saved probe to the name that you typed above"));
  remove_ = button(tr("Delete"), "deleteProbe", tr("Deletes the saved probe of this name"));
  reset_ = button(tr("Reset"), "resetProbe",
                  tr("Restores the values of the saved probe, or of the built-in probe of this shape"));
  auto* done =
      button(tr("Done"), "probeDone", tr("Closes the probe editor and returns to the image controls (Escape)"));
  done->setMinimumHeight(36);
  grid->addWidget(save_, 0, 0);
  grid->addWidget(reset_, 0, 1);
  grid->addWidget(rename_, 1, 0);
  grid->addWidget(remove_, 1, 1);
  grid->addWidget(done, 2, 0, 1, 2);
  connect(save_, &QPushButton::clicked, this, &ProbeEditor::save);
  connect(rename_, &QPushButton::clicked, this, &ProbeEditor::rename);
  connect(remove_, &QPushButton::clicked, this, &ProbeEditor::remove);
  connect(reset_, &QPushButton::clicked, this, &ProbeEditor::reset);
  connect(done, &QPushButton::clicked, this, &ProbeEditor::done);
  return foot;
}

QString ProbeEditor::problem() const {
  return problem_->isHidden() ? QString() : problem_->text();
}

void ProbeEditor::complain(const QString& sentence, QWidget* beside) {
  problem_->setText(sentence);
  problem_->setVisible(!sentence.isEmpty());
  numbers_->removeWidget(problem_);
  numbers_->insertWidget(beside ? numbers_->indexOf(beside) + 1 : 0, problem_);
}

void ProbeEditor::use(const std::string& what, QWidget* beside) {
  if (refreshing_) return;
  refreshing_ = true;
  const auto used = imaging_.useProbe(draft_, what);
  refreshing_ = false;
  complain(used ? QString() : QString::fromStdString(used.error().message), beside);
  showButtons();
}

void ProbeEditor::changed(const ProbeField& field, double value) {
  if (refreshing_) return;
  draft_.*field.member = value;
  const auto row = std::ranges::find(rows_, &field, &Row::field);
  use(std::string(field.name), row->slider);
}

void ProbeEditor::changeShape(int shape) {
  if (ProbeShape(shape) == draft_.shape) return;
  // Numbers that the other shape lacks come from its built-in probe.
  const bool wasLinear = draft_.shape == ProbeShape::Linear;
  const Probe other = *loadProbe(presetOf(ProbeShape(shape)));
  draft_.shape = ProbeShape(shape);
  if (wasLinear != (draft_.shape == ProbeShape::Linear) || draft_.faceRadius_mm < 5)
    for (const ProbeField& field : probeFields())
      if (field.use != ProbeField::Use::Always) draft_.*field.member = other.*field.member;
  if (draft_.shape == ProbeShape::Phased) draft_.faceRadius_mm = other.faceRadius_mm;
  use("shape", nullptr);
  show(Probe(draft_));
}

void ProbeEditor::changeName() {
  const std::string name = name_->text().trimmed().toStdString();
  if (name == draft_.name) return;
  draft_.name = name;
  use("name", nullptr);
}

void ProbeEditor::show(const Probe& probe) {
  const bool before = std::exchange(refreshing_, true);
  draft_ = probe;
  name_->setText(QString::fromStdString(probe.name));
  shape_->setCurrentIndex(int(probe.shape));
  apodization_->setCurrentIndex(int(probe.apodization));
  for (const Row& row : rows_) {
    ui::ValueRange range = row.slider->range();
    range.defaultValue =
        std::clamp(loadProbe(presetOf(probe.shape)).value_or(probe).*row.field->member, range.minimum, range.maximum);
    row.slider->setRange(range);
    row.slider->setVisible(applies(*row.field, probe.shape));
    if (applies(*row.field, probe.shape)) row.slider->setValue(probe.*row.field->member);
  }
  if (library_.find(probe.name)) savedName_ = probe.name;
  refreshing_ = before;
  complain({}, nullptr);
  showButtons();
}

void ProbeEditor::showButtons() {
  const bool own = library_.find(draft_.name) != nullptr;
  const bool valid = problem_->isHidden();
  hint_->setVisible(isBuiltIn(draft_.name));
  save_->setEnabled(valid && !isBuiltIn(draft_.name));
  save_->setText(own ? tr("Overwrite") : tr("Save"));
  save_->setToolTip(isBuiltIn(draft_.name)
                        ? tr("A built-in probe cannot be overwritten; type another name to save your probe")
                        : tr("Saves this probe under its name, in a file for this user"));
  remove_->setEnabled(own);
  const ProbeLibrary::Entry* last = library_.find(savedName_);
  rename_->setEnabled(valid && last && !own && !isBuiltIn(draft_.name));
}

void ProbeEditor::take(const Probe& probe) {
  draft_ = probe;
  use("picture", nullptr);
  if (!problem().isEmpty()) return;
  ImagingSettings settings = imaging_.settings();
  settings.depth_mm = probe.defaultDepth_mm;
  if (settings.depth_mm != imaging_.settings().depth_mm) imaging_.setSettings(settings);
  show(Probe(draft_));
}

bool ProbeEditor::report(const Result<void>& result, const QString& said) {
  if (result) status_.showMessage(said);
  complain(result ? QString() : QString::fromStdString(result.error().message), nullptr);
  showButtons();
  return result.has_value();
}

bool ProbeEditor::save() {
  changeName();
  const bool saved = report(library_.save(draft_), tr("Probe saved; it is in the list of probes."));
  if (saved) savedName_ = draft_.name;
  showButtons();
  return saved;
}

bool ProbeEditor::rename() {
  const bool renamed = report(library_.rename(savedName_, draft_.name), tr("Probe renamed."));
  if (renamed) savedName_ = draft_.name;
  showButtons();
  return renamed;
}

bool ProbeEditor::remove() {
  return report(library_.remove(draft_.name), tr("Probe deleted; it stays in use until you choose another probe."));
}

void ProbeEditor::reset() {
  const ProbeLibrary::Entry* own = library_.find(draft_.name);
  const Probe before = own ? own->probe : *loadProbe(isBuiltIn(draft_.name) ? draft_.name : presetOf(draft_.shape));
  take(before);
}

void ProbeEditor::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return Q_EMIT done();
  QWidget::keyPressEvent(event);
}

}  // namespace insonate::train
