#include "AboutDialog.h"

#include <insonate/embedded/help.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace insonate::ui {
namespace {

/// The help page without its heading, which is already above it.
QString aboutText() {
  for (const auto& file : embedded::help::files())
    if (file.name == "about") return qt(file.text).section(QLatin1Char('\n'), 1);
  return {};
}

}  // namespace

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("About Insonate"));
  setAttribute(Qt::WA_DeleteOnClose);
  const QString version = QCoreApplication::applicationVersion();
  auto* title = new QLabel(version.isEmpty() ? QStringLiteral("Insonate") : tr("Insonate %1").arg(version));
  setRole(title, "title");
  auto* page = new QTextBrowser;
  page->setAccessibleName(windowTitle());
  page->setOpenExternalLinks(true);
  page->setMarkdown(aboutText());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kLargeGap, kLargeGap, kLargeGap, kLargeGap);
  column->setSpacing(kGap);
  column->addWidget(title);
  column->addWidget(page, 1);
  column->addWidget(buttons);
  buttons->button(QDialogButtonBox::Close)->setFocus();
  resize(620, 560);
}

}  // namespace insonate::ui
