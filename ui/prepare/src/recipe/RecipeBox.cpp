#include "RecipeBox.h"

#include "../labels/LabelSession.h"
#include "../model/Notice.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"
#include "../model/TermsEditor.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/segmentation/Recipe.h>
#include <insonate/ui/LetterKeyFilter.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

constexpr int kRows = 5;

QString displayText(const LabelStep& step, const PrepareModel& shared) {
  const std::string_view name = nameOf(step.tool);
  QString words = ui::qt(name).replace(QLatin1Char('_'), QLatin1Char(' '));
  if (step.label != 0) words += QStringLiteral(": ") + shared.terms.nameOf(step.label);
  return words;
}

/// Not modal: the window stays usable.
template <class Chosen>
void ask(QWidget* parent, const char* name, const QString& title, QFileDialog::AcceptMode mode, Chosen chosen) {
  auto* dialog = new QFileDialog(parent, title, QDir::homePath(), RecipeBox::tr("Recipes (*.json)"));
  dialog->setObjectName(QLatin1String(name));
  dialog->setOption(QFileDialog::DontUseNativeDialog);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(mode);
  dialog->setFileMode(mode == QFileDialog::AcceptSave ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
  dialog->setDefaultSuffix(QStringLiteral("json"));
  QObject::connect(dialog, &QFileDialog::fileSelected, parent, chosen);
  dialog->open();
}

}  // namespace

RecipeBox::RecipeBox(PrepareModel& shared, QWidget* parent)
    : QWidget(parent),
      shared_(shared),
      replay_(shared.labeling, shared.openCase.undoStack(), this),
      none_(ui::paragraph("recipeNone", "quiet",
                          tr("Each change by a tool is listed here as a step. Save the steps as a recipe to replay "
                             "them on another case."))),
      steps_(new QListWidget),
      save_(ui::pushButton("recipeSave", tr("Save ..."), tr("Saves the labeling steps so far as a recipe file"))),
      load_(ui::pushButton(
          "recipeReplay", tr("Replay ..."),
          tr("Applies the steps of a recipe file to this case; locked and hidden labels stay unchanged"))) {
  steps_->setObjectName(QStringLiteral("recipeSteps"));
  steps_->setAccessibleName(tr("Labeling steps so far"));
  steps_->setToolTip(tr("Label edits since the case was opened, except undone edits"));
  steps_->setFixedHeight(kRows * steps_->fontMetrics().lineSpacing() * 3 / 2);
  new ui::LetterKeyFilter(steps_);
  auto* row = new QHBoxLayout;
  row->addWidget(save_, 1);
  row->addWidget(load_, 1);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  for (QWidget* one : {static_cast<QWidget*>(none_), static_cast<QWidget*>(steps_)}) box->addWidget(one);
  box->addLayout(row);
  connect(save_, &QPushButton::clicked, this, [this] { askSave(); });
  connect(load_, &QPushButton::clicked, this, [this] { askReplay(); });
  const LabelSession& labels = shared_.labeling;
  connect(&labels, &LabelSession::changed, this, [this] { refresh(); });
  connect(&labels, &LabelSession::busyChanged, this, [this] { refresh(); });
  connect(&labels, &LabelSession::caseSet, this, [this] {
    replay_.forget();
    refresh();
  });
  refresh();
}

void RecipeBox::refresh() {
  const Recipe made = shared_.labeling.recipe();
  steps_->clear();
  for (const LabelStep& step : made.steps)
    steps_->addItem(QStringLiteral("%1  %2").arg(steps_->count() + 1).arg(displayText(step, shared_)));
  steps_->scrollToBottom();
  none_->setVisible(made.steps.empty());
  steps_->setVisible(!made.steps.empty());
  const bool free = shared_.openCase.patient() && !shared_.labeling.isBusy() && !replay_.isRunning();
  save_->setEnabled(free && !made.steps.empty());
  load_->setEnabled(free);
}

void RecipeBox::askSave() {
  ask(this, "recipeSaveDialog", tr("Save the labeling steps as a recipe"), QFileDialog::AcceptSave,
      [this](const QString& file) { save(file); });
}

void RecipeBox::askReplay() {
  ask(this, "recipeReplayDialog", tr("Replay a recipe"), QFileDialog::AcceptOpen,
      [this](const QString& file) { replay(file); });
}

void RecipeBox::save(const QString& file) {
  Recipe made = shared_.labeling.recipe();
  made.description = "Labeling steps, in this order.";
  made.labels = shared_.terms.value().own;
  const auto ok = writeAtomically(file.toStdString(), textOf(made));
  shared_.notice.showMessage(ok ? tr("The steps are saved as a recipe, which can be replayed on another case.")
                                : QString::fromStdString(ok.error().message));
}

void RecipeBox::replay(const QString& file) {
  const auto recipe = loadRecipe(file.toStdString());
  if (!recipe) return shared_.notice.showMessage(QString::fromStdString(recipe.error().message));
  const std::size_t here = shared_.labeling.recipe().steps.size();
  replay_.run(recipe->steps, here, here, tr("Replaying the recipe"), [this, names = recipe->labels](bool well) {
    LabelTerms terms = shared_.terms.value();
    terms.own.insert(names.begin(), names.end());
    if (well && terms != shared_.terms.value())
      shared_.terms.set(std::move(terms), tr("name the labels of the recipe"));
    shared_.notice.showMessage(well ? tr("The recipe was replayed; Ctrl+Z undoes its steps.")
                                    : tr("The recipe was not replayed; the labels are unchanged."));
    refresh();
  });
  refresh();
}

}  // namespace insonate::prepare
