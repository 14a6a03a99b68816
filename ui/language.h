// The language of the window. Command lines, logs and files stay English, so that scripts can rely on them: only a program that
// makes a WindowTranslation is translated.
#pragma once

#include <QtCore/QLocale>
#include <QtCore/QStringList>
#include <QtCore/QTranslator>

#include <span>

namespace skyseal::ui {

struct Language
{
    const char *code; ///< ISO 639-1
    const char *name; ///< in the language itself
};

/// English, and those that resources/translations has a file for.
std::span<const Language> languages();

/// The code of the language to use: `chosen` if there is such a language, else the first of the `desktop`'s languages ("de-AT",
/// "en"), the preferred one first, that there is; English if there is none.
QString languageToUse(const QString &chosen, const QStringList &desktop);

/// The code of the language that tr() answers in.
QString languageInUse();

/// The path of a file of the resources in that language: `name` in the subfolder of its code, else in `folder` itself, in
/// English. `folder` ends with a slash.
QString translatedFile(const QString &folder, const QString &name);

/// Translates the texts of the program, and Qt's own ("Cancel") where its translations are installed, and makes QLocale() that
/// of the language, as long as it lives: the desktop's own one if it has this language. To be made before the first text is,
/// since many texts are made once.
class WindowTranslation
{
public:
    explicit WindowTranslation(const QString &code);
    ~WindowTranslation();
    WindowTranslation(const WindowTranslation &) = delete;
    WindowTranslation &operator=(const WindowTranslation &) = delete;

private:
    QTranslator m_program, m_qt;
    const QLocale m_before;
};

} // namespace skyseal::ui
