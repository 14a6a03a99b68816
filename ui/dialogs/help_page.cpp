#include "ui/dialogs/help_page.h"

#include "ui/language.h"
#include "ui/theme/grid.h"

#include <QtCore/QFile>
#include <QtGui/QTextBlock>
#include <QtGui/QTextDocument>

namespace skyseal::ui {

namespace {

const QString kFolder = QStringLiteral(":/skyseal/help/");

QString pageText(const QString &page, const QHash<QString, QString> &inserts)
{
    QFile file(translatedFile(kFolder, page + QStringLiteral(".md")));
    if (!file.open(QIODevice::ReadOnly))
        return HelpPage::tr("There is no help page \"%1\".").arg(page);
    QString text = QString::fromUtf8(file.readAll());
    for (auto insert = inserts.begin(); insert != inserts.end(); ++insert)
        text.replace(QStringLiteral("<!-- %1 -->").arg(insert.key()), insert.value());
    return text;
}

/// The paths of the pictures in a document, as its text names them.
QStringList picturesOf(const QTextDocument &document)
{
    QStringList out;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part)
            if (const QTextImageFormat image = part.fragment().charFormat().toImageFormat(); image.isValid())
                out << image.name();
    return out;
}

} // namespace

HelpPage::HelpPage(const QHash<QString, QString> &inserts, QWidget *parent) : QTextBrowser(parent), m_inserts(inserts)
{
    setObjectName(QStringLiteral("helpPage"));
    setAccessibleName(tr("Help page"));
    setFrameShape(QFrame::NoFrame);
    // The scroll bar takes its width from the pictures, whose height would decide whether it is there.
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    setOpenLinks(false); // a page has inserts and pictures of its own
    document()->setDocumentMargin(2 * kGrid);
    connect(this, &QTextBrowser::anchorClicked, this, [this](const QUrl &link) {
        if (const QString path = link.path(); path.endsWith(QLatin1String(".md")))
            open(path.chopped(3));
    });
}

void HelpPage::open(const QString &page)
{
    m_opened << page;
    show(page);
}

void HelpPage::back()
{
    if (m_opened.size() < 2)
        return;
    m_opened.removeLast();
    show(m_opened.last());
}

void HelpPage::show(const QString &page)
{
    setMarkdown(pageText(page, m_inserts));
    fitPictures();
    Q_EMIT canGoBackChanged(m_opened.size() > 1);
}

void HelpPage::fitPictures()
{
    const double ratio = devicePixelRatioF();
    const int width = viewport()->width() - 2 * static_cast<int>(document()->documentMargin());
    for (const QString &name : picturesOf(*document())) {
        QImage picture(kFolder + name);
        if (picture.isNull() || width < kGrid)
            continue;
        if (picture.width() > width * ratio)
            picture = picture.scaledToWidth(qRound(width * ratio), Qt::SmoothTransformation);
        picture.setDevicePixelRatio(ratio);
        document()->addResource(QTextDocument::ImageResource, QUrl(name), picture);
    }
    document()->markContentsDirty(0, document()->characterCount());
}

void HelpPage::resizeEvent(QResizeEvent *event)
{
    QTextBrowser::resizeEvent(event);
    fitPictures();
}

} // namespace skyseal::ui

#include "moc_help_page.cpp"
