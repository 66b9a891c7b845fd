package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import org.assertj.core.api.recursive.comparison.RecursiveComparisonConfiguration;
import org.junit.jupiter.api.Test;
import rsal.data.Blobs.Blob;
import rsal.data.Rgb;
import rsal.testkit.Rounds;

class BlobExtractorTest {
    private static final Rgb RED = new Rgb(255, 0, 0);
    private static final Rgb BLUE = new Rgb(0, 0, 255);

    /// Strips may show different things of one color, so that one begins where the one above it ends.
    @Test
    void blobsAreThePixelsOfOneColorThatHangTogether() {
        for (long seed = 0; seed < Rounds.of(100, 500); seed++) {
            var random = new SplittableRandom(seed);
            int columns = random.nextInt(1, 30);
            int rows = random.nextInt(1, 20);
            var image = new Rgb[columns][rows];
            var range = new double[columns][rows];
            BlobExtractor patches = BlobExtractor.ofThisThread();
            double empty = random.nextDouble();
            for (int column = 0; column < columns; column++) {
                int first = 0;
                while (first < rows) {
                    int end = Math.min(rows, first + random.nextInt(1, 6));
                    double distances = 0;
                    Rgb color = random.nextDouble() < empty ? null : random.nextBoolean() ? RED : BLUE;
                    for (int row = first; row < end; row++) {
                        image[column][row] = color;
                        range[column][row] = random.nextDouble();
                        distances += range[column][row];
                    }
                    if (color != null) {
                        patches.add(color, column, first, end, distances);
                    }
                    first = end;
                }
            }
            assertThat(patches.blobs())
                    .as("seed %d", seed)
                    .usingRecursiveFieldByFieldElementComparator(nearly())
                    .isEqualTo(flooded(image, range));
        }
    }

    private static RecursiveComparisonConfiguration nearly() {
        return RecursiveComparisonConfiguration.builder()
                .withComparatorForType((a, b) -> Math.abs(a - b) < 1e-9 ? 0 : Double.compare(a, b), Double.class)
                .build();
    }

    /// Fills one blob after the other from its first pixel.
    private static List<Blob> flooded(Rgb[][] image, double[][] range) {
        var blobs = new ArrayList<Blob>();
        for (int column = 0; column < image.length; column++) {
            for (int row = 0; row < image[column].length; row++) {
                if (image[column][row] != null) {
                    blobs.add(flood(image, range, column, row));
                }
            }
        }
        blobs.sort(Comparator.comparingInt(Blob::left)); // stable: they are in the order of their first pixels
        return blobs;
    }

    private record Pixel(int column, int row) {}

    private static Blob flood(Rgb[][] image, double[][] range, int column, int row) {
        Rgb color = image[column][row];
        var pixels = new ArrayList<>(List.of(new Pixel(column, row)));
        image[column][row] = null;
        for (int i = 0; i < pixels.size(); i++) {
            Pixel at = pixels.get(i);
            for (Pixel next : List.of(
                    new Pixel(at.column - 1, at.row),
                    new Pixel(at.column + 1, at.row),
                    new Pixel(at.column, at.row - 1),
                    new Pixel(at.column, at.row + 1))) {
                boolean inside =
                        next.column >= 0 && next.column < image.length && next.row >= 0 && next.row < image[0].length;
                if (inside && color.equals(image[next.column][next.row])) {
                    image[next.column][next.row] = null;
                    pixels.add(next);
                }
            }
        }
        var columns = pixels.stream().mapToInt(Pixel::column).summaryStatistics();
        var rows = pixels.stream().mapToInt(Pixel::row).summaryStatistics();
        return new Blob(
                color,
                columns.getMin(),
                rows.getMin(),
                columns.getMax() + 1,
                rows.getMax() + 1,
                columns.getAverage() + 0.5,
                rows.getAverage() + 0.5,
                pixels.size(),
                pixels.stream()
                        .mapToDouble(pixel -> range[pixel.column][pixel.row])
                        .average()
                        .orElseThrow());
    }
}
