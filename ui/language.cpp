#include "ui/language.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QLibraryInfo>

#include <algorithm>

namespace skyseal::ui {

namespace {

constexpr Language kLanguages[]{{"en", "English"}, {"de", "Deutsch"}};

bool isThere(const QString &code)
{
    return std::ranges::any_of(kLanguages, [&code](const Language &each) { return code == QLatin1String(each.code); });
}

} // namespace

std::span<const Language> languages()
{
    return kLanguages;
}

QString languageToUse(const QString &chosen, const QStringList &desktop)
{
    if (isThere(chosen))
        return chosen;
    // Not QTranslator::load(QLocale): English, which has no file, would give way to the desktop's second language.
    for (const QString &tag : desktop)
        if (QString code = tag.section(QLatin1Char('-'), 0, 0); isThere(code))
            return code;
    return QLatin1String(kLanguages[0].code);
}

QString languageInUse()
{
    return QCoreApplication::translate("skyseal::ui::Language", "en", "code of this language, as in the name of this file");
}

QString translatedFile(const QString &folder, const QString &name)
{
    const QString translated = folder + languageInUse() + QLatin1Char('/') + name;
    return QFile::exists(translated) ? translated : folder + name;
}

WindowTranslation::WindowTranslation(const QString &code)
{
    if (m_qt.load(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qt);
    if (m_program.load(QStringLiteral(":/skyseal/translations/skyseal_") + code))
        QCoreApplication::installTranslator(&m_program);
    const QLocale own(code), desktop = QLocale::system();
    QLocale::setDefault(desktop.language() == own.language() ? desktop : own);
}

WindowTranslation::~WindowTranslation()
{
    QLocale::setDefault(m_before);
}

} // namespace skyseal::ui
