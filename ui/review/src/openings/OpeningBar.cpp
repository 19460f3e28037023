#include "OpeningBar.h"

#include "../class/ClassController.h"
#include "../class/ClassWords.h"
#include "OpeningDialog.h"
#include "OpeningWords.h"

#include <insonate/ui/Commands.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QHBoxLayout>
#include <QKeySequence>

namespace insonate::review {
namespace {

constexpr int kAgain_ms = 10'000;

}  // namespace

OpeningBar::OpeningBar(ClassController& controller, ui::Commands& commands, QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      words_(new QLabel),
      tests_(ui::pushButton("classTests", tr("Tests"), {})) {
  words_->setObjectName(QStringLiteral("openTests"));
  words_->setTextFormat(Qt::PlainText);
  words_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  commands.beginSection(tr("Class"));
  commands.add(QStringLiteral("review.class.tests"), tr("opens and closes tests of the class"), *tests_,
               QKeySequence(QStringLiteral("Alt+T")));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(ui::kGap);
  row->addWidget(words_, 1);
  row->addWidget(tests_);
  connect(tests_, &QPushButton::clicked, this, [this] { showDialog(); });
  connect(&controller_, &ClassController::classChanged, this, [this] {
    sinceRead_.start();
    refresh();
  });
  connect(&again_, &QTimer::timeout, this, [this] { refresh(); });
  again_.start(kAgain_ms);
  refresh();
}

void OpeningBar::refresh() {
  const ClassFacts* facts = controller_.facts();
  const QString words =
      facts && controller_.teaches()
          ? openTestsWords(*facts, facts->read_us + (sinceRead_.isValid() ? sinceRead_.elapsed() : 0) * 1000)
          : QString();
  words_->setText(words);
  words_->setToolTip(plainToolTip(words));
  setVisible(!words.isEmpty());
}

void OpeningBar::showDialog() {
  if (controller_.facts() && controller_.facts()->curriculum) (new OpeningDialog(controller_, this))->open();
}

}  // namespace insonate::review
