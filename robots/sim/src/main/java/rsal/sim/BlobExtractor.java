package rsal.sim;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rsal.data.Blobs.Blob;
import rsal.data.Rgb;

/// Joins the pixels of an image to blobs: those of one color that have a side in common, whatever they show. Takes
/// strips of a column instead of pixels, column by column, and joins those that touch (union-find: Rosenfeld and
/// Pfaltz, Sequential Operations in Digital Picture Processing, 1966).
///
/// Each thread has one of these and uses it again and again.
final class BlobExtractor {
    private static final ThreadLocal<BlobExtractor> OF_THIS_THREAD = ThreadLocal.withInitial(BlobExtractor::new);

    private int count;
    private Rgb[] color = {};
    private int[] leader = {}; // an earlier strip of the same blob, or itself
    private int[] column = {};
    private int[] first = {}; // row
    private int[] end = {};
    private double[] distances = {};

    private int begin; // of the strips of the column at hand
    private int beside; // of those of the column before that may touch the next

    // of the blobs, where their leader is
    private int[] right = {};
    private int[] top = {};
    private int[] bottom = {};
    private int[] area = {};
    private double[] sumX = {};
    private double[] sumY = {};

    private BlobExtractor() {}

    /// That of this thread, empty.
    static BlobExtractor ofThisThread() {
        BlobExtractor patches = OF_THIS_THREAD.get();
        patches.count = 0;
        patches.begin = 0;
        patches.beside = 0;
        return patches;
    }

    /// Adds a strip, which is right of all that are there, or below them in the same column.
    ///
    /// @param itsEnd one past the last row
    /// @param itsWays sum of the ranges of its pixels [m]
    void add(Rgb itsColor, int itsColumn, int itsFirst, int itsEnd, double itsWays) {
        if (count == leader.length) {
            grow(Math.max(64, 2 * count));
        }
        int its = count++;
        color[its] = itsColor;
        leader[its] = its;
        column[its] = itsColumn;
        first[its] = itsFirst;
        end[its] = itsEnd;
        distances[its] = itsWays;
        if (its > 0 && column[its - 1] != itsColumn) {
            beside = column[its - 1] == itsColumn - 1 ? begin : its;
            begin = its;
        }
        if (its > begin && end[its - 1] == itsFirst) {
            join(its - 1, its);
        }
        while (beside < begin && end[beside] <= itsFirst) {
            beside++;
        }
        for (int other = beside; other < begin && first[other] < itsEnd; other++) {
            join(other, its);
        }
    }

    private void join(int one, int other) {
        if (color[one].equals(color[other])) {
            int a = leader(one);
            int b = leader(other);
            leader[Math.max(a, b)] = Math.min(a, b);
        }
    }

    /// The first strip of its blob.
    private int leader(int strip) {
        int at = strip;
        while (leader[at] != at) {
            leader[at] = leader[leader[at]];
            at = leader[at];
        }
        return at;
    }

    /// Those of all strips, from left to right; of those that begin in one column, from above.
    List<Blob> blobs() {
        int blobs = 0;
        for (int i = 0; i < count; i++) {
            int its = leader(i);
            if (its == i) {
                blobs++;
                top[i] = first[i];
                bottom[i] = 0;
                area[i] = 0;
                sumX[i] = 0;
                sumY[i] = 0;
            } else {
                distances[its] += distances[i];
            }
            int pixels = end[i] - first[i];
            right[its] = column[i] + 1;
            top[its] = Math.min(top[its], first[i]);
            bottom[its] = Math.max(bottom[its], end[i]);
            area[its] += pixels;
            sumX[its] += pixels * (column[i] + 0.5);
            sumY[its] += pixels * (first[i] + end[i]) / 2.0;
        }
        var all = new ArrayList<Blob>(blobs);
        for (int i = 0; i < count; i++) {
            if (leader[i] == i) {
                all.add(new Blob(
                        color[i],
                        column[i],
                        top[i],
                        right[i],
                        bottom[i],
                        sumX[i] / area[i],
                        sumY[i] / area[i],
                        area[i],
                        distances[i] / area[i]));
            }
        }
        return all;
    }

    private void grow(int size) {
        color = Arrays.copyOf(color, size);
        leader = Arrays.copyOf(leader, size);
        column = Arrays.copyOf(column, size);
        first = Arrays.copyOf(first, size);
        end = Arrays.copyOf(end, size);
        distances = Arrays.copyOf(distances, size);
        right = Arrays.copyOf(right, size);
        top = Arrays.copyOf(top, size);
        bottom = Arrays.copyOf(bottom, size);
        area = Arrays.copyOf(area, size);
        sumX = Arrays.copyOf(sumX, size);
        sumY = Arrays.copyOf(sumY, size);
    }
}
