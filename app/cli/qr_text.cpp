#include "app/cli/qr_text.h"

#ifdef SKYSEAL_QRENCODE
#include <qrencode.h>
#include <memory>
#endif

namespace skyseal::app {

#ifdef SKYSEAL_QRENCODE

bool canShowQr()
{
    return true;
}

std::string qrText(const std::string &content)
{
    struct Free
    {
        void operator()(QRcode *code) const { QRcode_free(code); }
    };
    const std::unique_ptr<QRcode, Free> code(QRcode_encodeString8bit(content.c_str(), 0, QR_ECLEVEL_M));
    if (!code)
        return {};
    constexpr int kQuiet = 4; // light modules around it, as the standard requires
    const int width = code->width;
    const auto dark = [&](int x, int y) {
        const bool inside = x >= 0 && y >= 0 && x < width && y < width;
        return inside && (code->data[y * width + x] & 1) != 0;
    };
    // Terminals are mostly dark: light modules are drawn, dark ones are not.
    std::string out;
    for (int y = -kQuiet; y < width + kQuiet; y += 2) {
        for (int x = -kQuiet; x < width + kQuiet; ++x) {
            const bool upper = !dark(x, y);
            const bool lower = !dark(x, y + 1);
            out += upper && lower ? "█" : upper ? "▀" : lower ? "▄" : " ";
        }
        out += '\n';
    }
    return out;
}

#else

bool canShowQr()
{
    return false;
}

std::string qrText(const std::string &)
{
    return {};
}

#endif

} // namespace skyseal::app
