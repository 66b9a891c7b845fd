package rsal.recording.animation;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOInvalidTreeException;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import org.jspecify.annotations.Nullable;

/// Writes an animated GIF (CompuServe, GIF89a Specification, 1990) that begins again at its end. Of each picture it
/// writes only the rectangle that has changed, and of that only pixels that have.
final class GifWriter implements AutoCloseable {
    private static final String FORMAT = "javax_imageio_gif_image_1.0";

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final IndexColorModel colors;
    private final ImageWriter writer;
    private final ImageOutputStream out;
    private final Map<Integer, Byte> nearest = new HashMap<>(); // by color
    private byte @Nullable [] before; // pixels as they are shown

    /// @throws IOException when this Java writes no GIF
    GifWriter(IndexColorModel colors) throws IOException {
        this.colors = colors;
        var writers = ImageIO.getImageWritersByFormatName("gif");
        if (!writers.hasNext()) {
            throw new IOException("This Java writes no GIF.");
        }
        this.writer = writers.next();
        this.out = ImageIO.createImageOutputStream(bytes);
        writer.setOutput(out);
        writer.prepareWriteSequence(null);
    }

    /// @param picture all of the same size
    /// @param shown for how long
    void add(BufferedImage picture, Duration shown) throws IOException {
        int width = picture.getWidth();
        int height = picture.getHeight();
        var now = new byte[width * height];
        int[] pixels = picture.getRGB(0, 0, width, height, null, 0, width);
        for (int i = 0; i < now.length; i++) {
            now[i] = nearest.computeIfAbsent(pixels[i] & 0xffffff, this::nearest);
        }
        byte[] old = before;
        before = now;
        if (old == null) {
            write(now, width, 0, 0, width, height, shown);
            return;
        }
        int left = width;
        int right = -1;
        int top = height;
        int bottom = -1;
        var changed = new byte[now.length];
        for (int i = 0; i < now.length; i++) {
            changed[i] = now[i] == old[i] ? (byte) Palette.TRANSPARENT : now[i];
            if (now[i] != old[i]) {
                left = Math.min(left, i % width);
                right = Math.max(right, i % width);
                top = Math.min(top, i / width);
                bottom = i / width;
            }
        }
        if (right < 0) { // nothing has changed, but it takes its time
            write(new byte[] {(byte) Palette.TRANSPARENT}, 1, 0, 0, 1, 1, shown);
        } else {
            write(changed, width, left, top, right - left + 1, bottom - top + 1, shown);
        }
    }

    /// @param pixels of a whole picture
    /// @param stride how many there are in its rows
    private void write(byte[] pixels, int stride, int left, int top, int width, int height, Duration shown)
            throws IOException {
        var part = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_INDEXED, colors);
        var row = new byte[width];
        for (int y = 0; y < height; y++) {
            System.arraycopy(pixels, (top + y) * stride + left, row, 0, width);
            part.getRaster().setDataElements(0, y, width, 1, row);
        }
        var metadata = writer.getDefaultImageMetadata(ImageTypeSpecifier.createFromRenderedImage(part), null);
        describe(metadata, left, top, shown);
        writer.writeToSequence(new IIOImage(part, null, metadata), null);
    }

    private static void describe(IIOMetadata metadata, int left, int top, Duration shown)
            throws IIOInvalidTreeException {
        var root = (IIOMetadataNode) metadata.getAsTree(FORMAT);
        IIOMetadataNode place = node(root, "ImageDescriptor");
        place.setAttribute("imageLeftPosition", Integer.toString(left));
        place.setAttribute("imageTopPosition", Integer.toString(top));
        IIOMetadataNode control = node(root, "GraphicControlExtension");
        control.setAttribute("disposalMethod", "doNotDispose");
        control.setAttribute("userInputFlag", "FALSE");
        control.setAttribute("transparentColorFlag", "TRUE");
        control.setAttribute("transparentColorIndex", Integer.toString(Palette.TRANSPARENT));
        control.setAttribute("delayTime", Long.toString(Math.max(2, Math.round(shown.toMillis() / 10.0))));
        var repeat = new IIOMetadataNode("ApplicationExtension");
        repeat.setAttribute("applicationID", "NETSCAPE");
        repeat.setAttribute("authenticationCode", "2.0");
        repeat.setUserObject(new byte[] {1, 0, 0}); // without end
        node(root, "ApplicationExtensions").appendChild(repeat);
        metadata.setFromTree(FORMAT, root);
    }

    private static IIOMetadataNode node(IIOMetadataNode root, String name) {
        for (int i = 0; i < root.getLength(); i++) {
            if (root.item(i).getNodeName().equals(name)) {
                return (IIOMetadataNode) root.item(i);
            }
        }
        var made = new IIOMetadataNode(name);
        root.appendChild(made);
        return made;
    }

    private byte nearest(int color) {
        int best = 0;
        int least = Integer.MAX_VALUE;
        for (int i = 0; i < Palette.TRANSPARENT; i++) {
            int red = colors.getRed(i) - (color >> 16);
            int green = colors.getGreen(i) - (color >> 8 & 0xff);
            int blue = colors.getBlue(i) - (color & 0xff);
            int off = red * red + green * green + blue * blue;
            if (off < least) {
                least = off;
                best = i;
            }
        }
        return (byte) best;
    }

    /// Ends it. Called once; nothing can be added any more.
    byte[] bytes() throws IOException {
        writer.endWriteSequence();
        out.flush();
        return bytes.toByteArray();
    }

    @Override
    public void close() throws IOException {
        writer.dispose();
        out.close();
    }
}
