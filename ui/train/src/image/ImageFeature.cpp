#include "ImageFeature.h"

#include "../layout/ControlsColumn.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "CineBar.h"
#include "CtBeside.h"
#include "EffectWords.h"
#include "EqualPanes.h"
#include "FreezeButton.h"
#include "ImageExports.h"
#include "ImageInput.h"
#include "ImagePanel.h"
#include "LinkedPointer.h"
#include "Measurements.h"
#include "StructureNames.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/ui/Workspace.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <QAction>
#include <QLabel>
#include <QSettings>
#include <algorithm>
#include <span>
#include <utility>

namespace insonate::train {

ImageFeature::ImageFeature(TrainModel& model, TrainLayout& layout, QWidget& probeChooser) : Feature(model, layout) {
  addCommands();
  addMeasuring();
  listGestures();
  besideAction_ = addSwitch("train.image.ctBeside", [this] { return beside_->isShown(); });
  buildNames();
  panel_ = new ImagePanel(model.disclosure, model.imaging, probeChooser, commands());
  layout.controls().addSection(panel_);
  layout.controls().setFoot(new FreezeButton(model.patientCase, model.live, commands().toolTip("train.image.freeze")));
  buildColumn();
  buildInput();
  connectModel();
  showCase();
}

void ImageFeature::buildNames() {
  names_ = new StructureNames(model_.disclosure, model_.hands, model_.patientCase, model_.live, layout_.views().image(),
                              this);
  QAction* action = addSwitch("train.image.names", [this] { return names_->isOn(); });
  connect(names_, &StructureNames::switched, action, &QAction::setChecked);
  connect(&model_.disclosure, &DisclosureModel::changed, action,
          [this, action] { action->setEnabled(model_.disclosure.current().anatomy); });
}

void ImageFeature::buildColumn() {
  ImageColumn& column = layout_.image();
  empty_ = new QLabel(&column);
  empty_->setObjectName("emptyState");
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  beside_ = new CtBeside(model_.patientCase, model_.live, &column);
  panes_ = new EqualPanes(&column);
  panes_->add(&layout_.views().imageWidget());
  panes_->add(&beside_->widget());
  vesselNote_ =
      new QLabel(tr("This case has no labeled vein and no labeled artery, so the image shows neither. Label the "
                    "vessels in Prepare; or label them in 3D Slicer or ITK-SNAP and reload the case in Prepare (F5)."));
  vesselNote_->setObjectName("vesselNote");
  vesselNote_->setWordWrap(true);
  vesselNote_->setContentsMargins(12, ui::kSmallGap, 12, ui::kSmallGap);
  ui::setRole(vesselNote_, "quiet");
  cine_ = new CineBar(model_.patientCase, model_.live, commands(), &column);
  column.add(ImageColumn::Image, empty_);
  column.add(ImageColumn::Image, panes_);
  column.add(ImageColumn::Note, vesselNote_);
  column.add(ImageColumn::Bar, cine_);
}

void ImageFeature::buildInput() {
  SharedViews& views = layout_.views();
  views.addSlice({&beside_->view(), &beside_->widget()});
  QWidget& canvas = *views.imageWidget().focusProxy();
  auto* input = new ImageInput(model_.imaging, model_.motion, model_.needle, views.image(), canvas, this);
  measurements_ = new Measurements(model_.status, model_.history, views, *input, *cine_, this);
  auto* pointer = new LinkedPointer(model_.patientCase, model_.live, views.image(), canvas, this);
  const auto addToPointer = [pointer](const SharedViews::Slice& slice) {
    pointer->addSlice(*slice.view, *slice.widget->focusProxy());
  };
  for (const SharedViews::Slice& slice : views.slices()) addToPointer(slice);
  connect(&views, &SharedViews::sliceAdded, pointer, addToPointer);
  exports_ = new ImageExports({model_.patientCase, model_.live, model_.status, *cine_, *input, *panes_},
                              layout_.workspace(), this);
}

void ImageFeature::connectModel() {
  SharedViews& views = layout_.views();
  connect(&model_.patientCase, &CaseModel::caseChanged, this, [this] { showCase(); });
  connect(&model_.patientCase, &CaseModel::structuresKnown, this, [this] { showPlacing(); });
  connect(&model_.motion, &ProbeMotion::placingChanged, this, [this] { showPlacing(); });
  connect(&model_.live, &LiveModel::pictureShown, this, [this] { showImage(); });
  connect(&model_.live, &LiveModel::frozenChanged, this, [this] { showFrozen(); });
  connect(&model_.live, &LiveModel::staleChanged, this, [this] { showStale(); });
  connect(&model_.imaging, &ImagingModel::setupChanged, this, [this] { showNotice(); });
  connect(&model_.disclosure, &DisclosureModel::changed, this, [this] {
    const bool anatomy = model_.disclosure.current().anatomy;
    if (!anatomy && beside_->isShown()) setCtBeside(false);
    cine_->setCtBesideOffered(anatomy);
    besideAction_->setEnabled(anatomy);
  });
  connect(&views, &SharedViews::boundsChanged, this, [this] {
    shape_ = nullptr;
    if (model_.live.shown()) showImage();
  });
  connect(&views, &SharedViews::windowLevelChanged, this,
          [this](views::WindowLevel value) { beside_->view().setWindowLevel(value); });
  connect(cine_, &CineBar::ctBesideChosen, this, [this](bool on) { setCtBeside(on); });
}

void ImageFeature::addCommands() {
  beginSection(KeySection::Image);
  addCommand({.id = "train.image.freeze",
              .text = {},
              .does = tr("freezes or unfreezes the image"),
              .listed = tr("Space, F"),
              .keys = keys({Qt::Key_Space, Qt::Key_F}),
              .perform = once([this] { model_.live.setFrozen(!model_.live.isFrozen()); })});
  const auto step = [this](int key, int by) -> ui::CommandKey {
    return {key, {}, [this, by](ui::KeyPress) { model_.live.showCine(model_.live.cineIndex() + by); }};
  };
  addCommand({.id = "train.image.step",
              .text = {},
              .does = tr("while the image is frozen, shows the previous or next image of the last seconds"),
              .listed = tr("Comma, Period"),
              .keys = {step(Qt::Key_Comma, -1), step(Qt::Key_Period, 1)},
              .perform = {}});
  addCommand({.id = "train.image.save",
              .text = tr("Image ..."),
              .does = tr("saves the image at its own resolution, with its depth scale in mm"),
              .listed = tr("Ctrl+P"),
              .keys = keys({Qt::Key_P}, Qt::ControlModifier),
              .perform = [this](ui::KeyPress) { exports_->askPicture(); }});
  addCommand({.id = "train.image.ctBeside",
              .text = tr("CT beside the image"),
              .does = tr("shows or hides the CT of the same plane, at the same scale, beside the image"),
              .listed = tr("C"),
              .keys = keys({Qt::Key_C}),
              .perform = [this](ui::KeyPress) { setCtBeside(!beside_->isShown()); }});
  addCommand({.id = "train.image.names",
              .text = tr("Names of structures"),
              .does = tr("shows or hides the names of the structures over the image"),
              .listed = tr("Ctrl+N"),
              .keys = keys({Qt::Key_N}, Qt::ControlModifier),
              .perform = once([this] {
                if (model_.disclosure.mayShowAnatomy()) names_->setOn(!names_->isOn());
              })});
  addCommand({.id = "train.image.nextEffect",
              .text = {},
              .does = tr("shows only the next or previous effect of the ultrasound model"),
              .listed = tr("N, Shift+N"),
              .keys = keys({Qt::Key_N}),
              .perform = [this](ui::KeyPress press) { model_.imaging.stepEffect(press.wide ? -1 : 1); }});
  addCommand({.id = "train.image.wholeImage",
              .text = {},
              .does = tr("shows all effects of the ultrasound model again"),
              .listed = tr("0"),
              .keys = keys({Qt::Key_0}),
              .perform = [this](ui::KeyPress) { model_.imaging.setEffect(ImagingModel::kWholeModel); }});
}

void ImageFeature::addMeasuring() {
  const auto choose = [this](views::CaliperKind kind) -> Perform {
    return [this, kind](ui::KeyPress) { measurements_->choose(int(kind)); };
  };
  beginSection(KeySection::Measurements);
  addCommand({.id = "train.measure.distance",
              .text = tr("Distance"),
              .does = tr("measures the distance between two points, in mm"),
              .listed = tr("L"),
              .keys = keys({Qt::Key_L}),
              .perform = choose(views::CaliperKind::Distance)});
  addCommand({.id = "train.measure.ellipse",
              .text = tr("Ellipse"),
              .does = tr("measures an ellipse in mm and mm²: first one axis, then the width"),
              .listed = tr("O"),
              .keys = keys({Qt::Key_O}),
              .perform = choose(views::CaliperKind::Ellipse)});
  addCommand(
      {.id = "train.measure.angle",
       .text = tr("Angle"),
       .does =
           tr("measures an angle in degrees: first a point on one arm, then the vertex, then a point on the other arm"),
       .listed = tr("V"),
       .keys = keys({Qt::Key_V}),
       .perform = choose(views::CaliperKind::Angle)});
  addCommand({.id = "train.measure.end",
              .text = {},
              .does = tr("ends measuring"),
              .listed = tr("Esc"),
              .keys = keys({Qt::Key_Escape}),
              .perform = [this](ui::KeyPress) { measurements_->choose(-1); },
              .isAvailable = [this] { return isPatientShown() && measurements_->isMeasuring(); }});
  addCommand({.id = "train.measure.clear",
              .text = tr("Remove all"),
              .does = tr("removes all measurements"),
              .listed = tr("Delete"),
              .keys = keys({Qt::Key_Delete}),
              .perform = [this](ui::KeyPress) { measurements_->clear(); }});
}

void ImageFeature::listGestures() {
  beginSection(KeySection::Probe);
  commands().addListed(tr("Left drag on the image"), tr("slides the probe"));
  commands().addListed(tr("Right drag on the image"), tr("rotates the probe; with Shift tilts and rocks it"));
  commands().addListed(tr("Wheel on the image"),
                       tr("compresses or releases the tissue; with Ctrl, changes the depth of the image"));
  beginSection(KeySection::Image);
  commands().addListed(tr("Pointing at image or CT"),
                       tr("marks the point under the pointer in the other view, CT or image"));
}

void ImageFeature::showCase() {
  views::UltrasoundView& image = layout_.views().image();
  shape_ = nullptr;
  isImageThere_ = false;
  image.setImage({});
  image.setColor({});
  image.setFrozen(false);
  layout_.views().imageWidget().forget();
  beside_->widget().forget();
  measurements_->forget();
  empty_->setVisible(!model_.patientCase.patient());
  showPlacing();
  setOpeningText({});
  showNotice();
}

void ImageFeature::showPlacing() {
  const CaseModel& patientCase = model_.patientCase;
  panes_->setVisible(patientCase.patient() && !model_.motion.isUnplaced());
  vesselNote_->setVisible(patientCase.patient() && patientCase.lacksVessels());
}

void ImageFeature::setOpeningText(const QString& what) {
  empty_->setText(what.isEmpty()
                      ? tr("No case is open.\n\nDrop a case, a folder of DICOM files or a CT file on the window,\n"
                           "or choose Case > Open case (Ctrl+O), or Case > Built-in neck (Ctrl+T).")
                      : tr("%1 ...").arg(what));
}

void ImageFeature::setCompact(bool isCompact) {
  cine_->setCompact(isCompact);
}

void ImageFeature::showImage() {
  const LiveFrame& frame = *model_.live.shown();
  views::UltrasoundView& image = layout_.views().image();
  const bool isFirst = !std::exchange(isImageThere_, true);
  image.setImage(frame.image);
  image.setColor(frame.color);
  image.setLateral(frame.patientFromProbe.linear.column[0]);
  if (frame.setup != shape_) {
    const BeamGrid grid(frame.setup->probe, frame.setup->settings);
    const auto bounds =
        layout_.views().boundsFor({grid.minLateral_mm(), grid.maxLateral_mm(), grid.minAxial_mm(), grid.maxAxial_mm()});
    if (bounds) {
      shape_ = frame.setup;
      image.setBounds(*bounds);
      image.setFocus(shape_->settings.focus_mm);
      const auto& tgc_dB = shape_->settings.tgc_dB;
      const bool flat = std::ranges::all_of(tgc_dB, [](double dB) { return dB == 0; });
      image.setTgc(flat ? std::span<const double>() : std::span<const double>(tgc_dB));
    }
  }
  const bool isCoarseNow = std::exchange(isCoarse_, frame.isCoarse) != frame.isCoarse;
  if (isFirst || isCoarseNow) showNotice();
}

void ImageFeature::showNotice() {
  const std::string& effect = model_.imaging.effect();
  const bool isOneEffect = effect != ImagingModel::kWholeModel;
  QString words = isOneEffect ? tr("ONLY %1").arg(effectWords(effect)) : QString();
  if (!model_.live.shown())
    words = tr("Building the first image ...");
  else if (words.isEmpty() && model_.live.shown()->isCoarse)
    words = tr("Preview: small structures are missing");
  layout_.views().image().setNotice(words.toStdString());
  if (std::exchange(isOneEffect_, isOneEffect) == isOneEffect && !isOneEffect) return;
  model_.status.showMessage(isOneEffect ? tr("The image shows one effect only; press 0 to show all effects.")
                                        : tr("The image shows all effects again."));
}

void ImageFeature::showStale() {
  const QString words = model_.live.isStale() ? tr("Image of the previous position") : QString();
  layout_.views().image().setStaleMark(words.toStdString());
}

void ImageFeature::showFrozen() {
  layout_.views().image().setFrozen(model_.live.isFrozen());
  // Measurements lie on the frozen image.
  if (!model_.live.isFrozen()) measurements_->clearImage();
}

void ImageFeature::setCtBeside(bool isShown) {
  if (isShown && !model_.disclosure.mayShowAnatomy()) return;
  besideAction_->setChecked(isShown);
  // Leaving the full size of a view would show what was visible before.
  layout_.views().restoreSizes();
  beside_->setShown(isShown);
  cine_->setCtBeside(isShown);
}

void ImageFeature::save(QSettings& settings) const {
  settings.setValue("ctBeside", beside_->isShown());
  settings.setValue("structureNames", names_->isOn());
  exports_->save(settings);
  panel_->save(settings);
}

void ImageFeature::restore(QSettings& settings) {
  setCtBeside(settings.value("ctBeside", false).toBool());
  names_->setOn(settings.value("structureNames", false).toBool());
  exports_->restore(settings);
  panel_->restore(settings);
}

}  // namespace insonate::train
