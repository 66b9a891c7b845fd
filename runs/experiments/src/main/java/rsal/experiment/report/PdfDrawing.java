package rsal.experiment.report;

import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.PathIterator;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.pdmodel.PDPage;
import org.apache.pdfbox.pdmodel.PDPageContentStream;
import org.apache.pdfbox.pdmodel.common.PDRectangle;
import org.apache.pdfbox.pdmodel.graphics.state.PDExtendedGraphicsState;
import org.apache.pdfbox.util.Matrix;

/// A drawing as a page of PDF for a paper. Letters are outlines, so that no font has to be embedded, which publishers
/// ask for.
final class PdfDrawing implements Drawing {
    private static final FontRenderContext EXACT = new FontRenderContext(null, true, true);
    private static final long ALWAYS_THE_SAME = 1; // identity of the file, else made of the time

    private final PDPageContentStream page;
    private final Font font;

    private PdfDrawing(PDPageContentStream page, Font font) {
        this.page = page;
        this.font = font;
    }

    static byte[] of(ReportFigure figure, Print print) {
        double scale = print.widthInPoints() / print.width();
        double height = figure.picture().height(print.width()) * scale;
        var bytes = new ByteArrayOutputStream();
        try (var document = new PDDocument()) {
            document.setDocumentId(ALWAYS_THE_SAME);
            document.getDocumentInformation().setTitle(figure.alternative());
            var sheet = new PDPage(new PDRectangle((float) print.widthInPoints(), (float) height));
            document.addPage(sheet);
            try (var page = new PDPageContentStream(document, sheet)) {
                page.transform(new Matrix(new AffineTransform(scale, 0, 0, -scale, 0, height))); // y goes down
                figure.picture().draw(new PdfDrawing(page, print.font()), print.width());
            }
            document.save(bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    /// Writes to memory, which does not fail.
    private interface Strokes {
        void draw() throws IOException;
    }

    private static void write(Strokes strokes) {
        try {
            strokes.draw();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, double width, Ink ink) {
        write(() -> {
            page.setStrokingColor(Colors.of(ink));
            page.setLineWidth((float) width);
            page.moveTo((float) x1, (float) y1);
            page.lineTo((float) x2, (float) y2);
            page.stroke();
        });
    }

    @Override
    public void bar(double x, double y, double width, double height, Ink ink) {
        write(() -> {
            page.setNonStrokingColor(Colors.of(ink));
            page.addRect((float) x, (float) y, (float) width, (float) height);
            page.fill();
        });
    }

    @Override
    public void band(double x, double y, double width, double height, Ink ink) {
        faint(0.11f, () -> bar(x, y, width, height, ink));
    }

    @Override
    public void box(double x, double y, double width, double height, Ink ink) {
        faint(0.16f, () -> bar(x, y, width, height, ink));
        write(() -> {
            page.setStrokingColor(Colors.of(ink));
            page.setLineWidth(1.2f);
            page.addRect((float) x, (float) y, (float) width, (float) height);
            page.stroke();
        });
    }

    private void faint(float opacity, Strokes strokes) {
        write(() -> {
            page.saveGraphicsState();
            var state = new PDExtendedGraphicsState();
            state.setNonStrokingAlphaConstant(opacity);
            page.setGraphicsStateParameters(state);
            strokes.draw();
            page.restoreGraphicsState();
        });
    }

    @Override
    public void dot(double x, double y, double radius, Ink ink) {
        fill(circle(x, y, radius), Colors.of(ink));
    }

    @Override
    public void ring(double x, double y, double radius, Ink ink) {
        write(() -> {
            page.setStrokingColor(Colors.of(ink));
            page.setLineWidth(1);
            trace(circle(x, y, radius));
            page.stroke();
        });
    }

    private static Shape circle(double x, double y, double radius) {
        return new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius);
    }

    @Override
    public void text(double x, double y, String text, Align align, Ink ink) {
        var glyphs = font.createGlyphVector(EXACT, text);
        double width = glyphs.getLogicalBounds().getWidth();
        double left = switch (align) {
            case START -> x;
            case MIDDLE -> x - width / 2;
            case END -> x - width;
        };
        fill(glyphs.getOutline((float) left, (float) y), Colors.of(ink));
    }

    private void fill(Shape shape, Color color) {
        write(() -> {
            page.setNonStrokingColor(color);
            if (trace(shape)) {
                page.fill();
            }
        });
    }

    /// @return whether there is anything, which is not so of spaces
    private boolean trace(Shape shape) throws IOException {
        var at = new double[6];
        double x = 0;
        double y = 0;
        boolean any = false;
        for (PathIterator path = shape.getPathIterator(null); !path.isDone(); path.next()) {
            any = true;
            int last = // coordinate of the end
                    switch (path.currentSegment(at)) {
                        case PathIterator.SEG_MOVETO -> {
                            page.moveTo((float) at[0], (float) at[1]);
                            yield 0;
                        }
                        case PathIterator.SEG_LINETO -> {
                            page.lineTo((float) at[0], (float) at[1]);
                            yield 0;
                        }
                        case PathIterator.SEG_QUADTO -> { // the same curve as one of the third order
                            page.curveTo(
                                    (float) (x + 2 * (at[0] - x) / 3),
                                    (float) (y + 2 * (at[1] - y) / 3),
                                    (float) (at[2] + 2 * (at[0] - at[2]) / 3),
                                    (float) (at[3] + 2 * (at[1] - at[3]) / 3),
                                    (float) at[2],
                                    (float) at[3]);
                            yield 2;
                        }
                        case PathIterator.SEG_CUBICTO -> {
                            page.curveTo(
                                    (float) at[0], (float) at[1], (float) at[2], (float) at[3], (float) at[4], (float)
                                            at[5]);
                            yield 4;
                        }
                        default -> {
                            page.closePath();
                            yield -1; // a path goes on with a move
                        }
                    };
            if (last >= 0) {
                x = at[last];
                y = at[last + 1];
            }
        }
        return any;
    }
}
