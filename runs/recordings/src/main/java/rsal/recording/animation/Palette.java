package rsal.recording.animation;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/// The colors of an animation: the most frequent of its pictures (P. Heckbert, Color Image Quantization for Frame
/// Buffer Display, SIGGRAPH 1982, the popularity algorithm), and one for what is transparent.
final class Palette {
    /// Number of the color that shows what was there before.
    static final int TRANSPARENT = 255;

    private final Map<Integer, Integer> counts = new LinkedHashMap<>(); // by color, the first seen first

    void count(BufferedImage picture) {
        int[] pixels = picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth());
        for (int pixel : pixels) {
            counts.merge(pixel & 0xffffff, 1, Integer::sum);
        }
    }

    IndexColorModel model() {
        List<Integer> chosen = counts.entrySet().stream()
                .sorted(Map.Entry.<Integer, Integer>comparingByValue().reversed()) // of equal counts, the first seen
                .limit(TRANSPARENT)
                .map(Map.Entry::getKey)
                .toList();
        var red = new byte[TRANSPARENT + 1];
        var green = new byte[TRANSPARENT + 1];
        var blue = new byte[TRANSPARENT + 1];
        for (int i = 0; i < chosen.size(); i++) {
            red[i] = (byte) (chosen.get(i) >> 16);
            green[i] = (byte) (chosen.get(i) >> 8);
            blue[i] = chosen.get(i).byteValue();
        }
        return new IndexColorModel(8, red.length, red, green, blue, TRANSPARENT);
    }
}
