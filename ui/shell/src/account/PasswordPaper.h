#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/FirstPassword.h>

#include <QString>
#include <vector>

class QTextDocument;
class QWidget;

namespace insonate::ui {

/// Fills a page to cut into strips, each with a person's name and password. Names are inserted as plain text, whatever
/// they contain.
void fillPasswordPaper(QTextDocument& paper, const QString& cohort, const std::vector<FirstPassword>& passwords);

/// Asks for a printer. Says where the page went: to a printer, or as a file that its owner alone can read; "" where the
/// user thought better of it.
Result<QString> printPasswordPaper(const QString& cohort, const std::vector<FirstPassword>& passwords, QWidget* parent);

}  // namespace insonate::ui
