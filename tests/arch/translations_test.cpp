// The translations of the window: complete, and of the form of what they translate.
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QDirIterator>
#include <QtCore/QFile>
#include <QtCore/QRegularExpression>
#include <QtCore/QXmlStreamReader>
#include <QtTest/QTest>

#include <algorithm>
#include <map>

namespace {

/// Context, source text and comment.
using TextKey = std::array<QString, 3>;

struct TranslatedText
{
    bool finished = false;
    QStringList forms; ///< one, or one for each plural form
};

using TranslatedTexts = std::map<TextKey, TranslatedText>;

TranslatedTexts readTranslations(const QString &name)
{
    QFile file(QStringLiteral(SKYSEAL_SOURCE_DIR "/resources/translations/") + name);
    TranslatedTexts out;
    if (!file.open(QIODevice::ReadOnly))
        return out;
    QXmlStreamReader xml(&file);
    TextKey key;
    TranslatedText text;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isEndElement() && xml.name() == QLatin1String("message")) {
            out[key] = text;
            continue;
        }
        if (!xml.isStartElement())
            continue;
        if (xml.name() == QLatin1String("name"))
            key[0] = xml.readElementText();
        else if (xml.name() == QLatin1String("message"))
            key[2].clear();
        else if (xml.name() == QLatin1String("source"))
            key[1] = xml.readElementText();
        else if (xml.name() == QLatin1String("comment"))
            key[2] = xml.readElementText();
        else if (xml.name() == QLatin1String("translation")) {
            text = {!xml.attributes().hasAttribute(QLatin1String("type")), {}};
            QString only;
            while (!xml.atEnd()
                   && !(xml.readNext() == QXmlStreamReader::EndElement && xml.name() == QLatin1String("translation"))) {
                if (xml.isStartElement())
                    text.forms << xml.readElementText();
                else if (xml.isCharacters())
                    only += xml.text();
            }
            if (text.forms.isEmpty())
                text.forms << only;
        }
    }
    if (xml.hasError())
        out.clear();
    return out;
}

QStringList matches(const QString &text, const QString &pattern)
{
    QStringList out;
    for (auto match = QRegularExpression(pattern).globalMatch(text); match.hasNext();)
        out << match.next().captured();
    std::ranges::sort(out);
    return out;
}

/// The parts of a text's form that its translation has to keep, by name. The mark at the end says what follows: a dialog, a
/// field.
QString lostForm(const QString &source, const QString &translation)
{
    static const std::pair<QString, QString> kForms[]{
        {QStringLiteral("markers"), QStringLiteral("%L?([0-9]{1,2}|n)")},
        {QStringLiteral("mnemonic"), QStringLiteral("(?<!&)&(?=[^&\\s])")},
        {QStringLiteral("end"), QStringLiteral("[.:…?!]\\s*$")},
        {QStringLiteral("space"), QStringLiteral("^\\s+|\\s+$")},
        {QStringLiteral("lines"), QStringLiteral("\n")},
    };
    for (const auto &[name, pattern] : kForms) {
        const QStringList expected = matches(source, pattern), found = matches(translation, pattern);
        if (name == QLatin1String("mnemonic") ? expected.size() != found.size() : expected != found)
            return name;
    }
    return {};
}

} // namespace

class TranslationsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// They are collected by the name of a function of this program, which lupdate must be told.
    void everyReasonIsCollected()
    {
        static const QRegularExpression kSentence(
            QStringLiteral("\\bsentence\\(\\s*\"(Reason|Metric)\",\\s*((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)\\)"));
        static const QRegularExpression kPart(QStringLiteral("\"((?:[^\"\\\\]|\\\\.)*)\""));
        const TranslatedTexts known = readTranslations(QStringLiteral("skyseal.ts"));
        int found = 0;
        for (const char *room : {"core", "app"}) {
            QDirIterator files(QStringLiteral(SKYSEAL_SOURCE_DIR "/") + QLatin1String(room),
                               {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files, QDirIterator::Subdirectories);
            while (files.hasNext()) {
                QFile file(files.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                const QString text = QString::fromUtf8(file.readAll());
                for (auto match = kSentence.globalMatch(text); match.hasNext(); ++found) {
                    QString source;
                    const QRegularExpressionMatch sentence = match.next();
                    for (auto part = kPart.globalMatch(sentence.captured(2)); part.hasNext();)
                        source += part.next().captured(1).replace(QStringLiteral("\\\""), QStringLiteral("\""));
                    QVERIFY2(known.contains({sentence.captured(1), source, QString()}), qPrintable(source));
                }
            }
        }
        QVERIFY(found > 200);
    }

    void lostFormIsFound_data()
    {
        QTest::addColumn<QString>("source");
        QTest::addColumn<QString>("translation");
        QTest::addColumn<QString>("lost");
        const auto row = [](const char *name, const char *source, const char *translation, const char *lost) {
            QTest::newRow(name) << QString::fromUtf8(source) << QString::fromUtf8(translation) << QString::fromUtf8(lost);
        };
        row("alike", "&Replay %1 of %2…", "%2: %1 &wiedergeben…", "");
        row("missing marker", "Switched from %1 to %2", "Gewechselt zu %2", "markers");
        row("other marker", "%1 messages", "%2 Nachrichten", "markers");
        row("marker twice", "%1 messages", "%1 %1 Nachrichten", "markers");
        row("plural marker", "%n messages", "Nachrichten", "markers");
        row("local marker", "%L1 tiles", "%1 Kacheln", "markers");
        row("no mnemonic", "&File", "Datei", "mnemonic");
        row("two mnemonics", "&File", "&Da&tei", "mnemonic");
        row("mnemonic of its own", "File", "&Datei", "mnemonic");
        row("an ampersand", "Keys && peers", "Schlüssel && Gegenstellen", "");
        row("no dialog", "Browse…", "Durchsuchen", "end");
        row("a sentence", "The demo runs", "Die Demo läuft.", "end");
        row("a field", "Name:", "Name", "end");
        row("suffix", " m", "m", "space");
        row("one line", "Sealed\nPeer", "Versiegelt, Gegenstelle", "lines");
    }
    void lostFormIsFound()
    {
        QFETCH(QString, source);
        QFETCH(QString, translation);
        QFETCH(QString, lost);
        QCOMPARE(lostForm(source, translation), lost);
    }

    void everyTextIsTranslated_data() { languageRows(); }
    void everyTextIsTranslated()
    {
        QFETCH(QString, file);
        const TranslatedTexts wanted = readTranslations(QStringLiteral("skyseal.ts")), texts = readTranslations(file);
        QVERIFY(wanted.size() > 1000);
        QStringList faults;
        for (const auto &[key, unused] : wanted)
            if (!texts.contains(key))
                faults << QStringLiteral("missing: %1: %2").arg(key[0], key[1]);
        for (const auto &[key, text] : texts) {
            if (!wanted.contains(key))
                faults << QStringLiteral("not in the template: %1: %2").arg(key[0], key[1]);
            if (!text.finished || text.forms.contains(QString()))
                faults << QStringLiteral("not translated: %1: %2").arg(key[0], key[1]);
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    }

    void formIsKept_data() { languageRows(); }
    void formIsKept()
    {
        QFETCH(QString, file);
        QStringList faults;
        for (const auto &[key, text] : readTranslations(file))
            for (const QString &form : text.forms)
                if (const QString lost = lostForm(key[1], form); !form.isEmpty() && !lost.isEmpty())
                    faults << QStringLiteral("%1: %2: \"%3\" is \"%4\"").arg(lost, key[0], key[1], form);
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    }

private:
    static void languageRows()
    {
        QTest::addColumn<QString>("file");
        const QDir folder(QStringLiteral(SKYSEAL_SOURCE_DIR "/resources/translations"));
        for (const QString &file : folder.entryList({QStringLiteral("skyseal_*.ts")}))
            QTest::newRow(qPrintable(file)) << file;
    }
};

SKYSEAL_TEST_APPLESS(TranslationsTest)
#include "translations_test.moc"
