package rsal.experiment.report;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.ImageIO;

/// A drawing as a picture for slides and papers, always light.
final class PngDrawing implements Drawing {
    private static final int SCALE = 2; // pixels of the picture per pixel of the figure
    private static final int BAND = 28; // opacity, of 255

    private final Graphics2D graphics;

    private PngDrawing(Graphics2D graphics) {
        this.graphics = graphics;
    }

    static byte[] of(ReportFigure figure) {
        int height = (int) Math.ceil(figure.picture().height(ReportFigure.WIDTH));
        var image = new BufferedImage((int) (SCALE * ReportFigure.WIDTH), SCALE * height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, image.getWidth(), image.getHeight());
        graphics.scale(SCALE, SCALE);
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 1).deriveFont((float) ReportFigure.TEXT));
        figure.picture().draw(new PngDrawing(graphics), ReportFigure.WIDTH);
        graphics.dispose();
        var bytes = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, "png", bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, double width, Ink ink) {
        graphics.setColor(Colors.of(ink));
        graphics.setStroke(new BasicStroke((float) width));
        graphics.draw(new Line2D.Double(x1, y1, x2, y2));
    }

    @Override
    public void bar(double x, double y, double width, double height, Ink ink) {
        graphics.setColor(Colors.of(ink));
        graphics.fill(new Rectangle2D.Double(x, y, width, height));
    }

    @Override
    public void band(double x, double y, double width, double height, Ink ink) {
        graphics.setColor(faint(ink, BAND));
        graphics.fill(new Rectangle2D.Double(x, y, width, height));
    }

    private static Color faint(Ink ink, int alpha) {
        Color color = Colors.of(ink);
        return new Color(color.getRed(), color.getGreen(), color.getBlue(), alpha);
    }

    @Override
    public void box(double x, double y, double width, double height, Ink ink) {
        graphics.setColor(faint(ink, 40));
        graphics.fill(new Rectangle2D.Double(x, y, width, height));
        graphics.setColor(Colors.of(ink));
        graphics.setStroke(new BasicStroke(1.2f));
        graphics.draw(new Rectangle2D.Double(x, y, width, height));
    }

    @Override
    public void dot(double x, double y, double radius, Ink ink) {
        graphics.setColor(Colors.of(ink));
        graphics.fill(circle(x, y, radius));
    }

    @Override
    public void ring(double x, double y, double radius, Ink ink) {
        graphics.setColor(Colors.of(ink));
        graphics.setStroke(new BasicStroke(1));
        graphics.draw(circle(x, y, radius));
    }

    private static Ellipse2D circle(double x, double y, double radius) {
        return new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius);
    }

    @Override
    public void text(double x, double y, String text, Align align, Ink ink) {
        graphics.setColor(Colors.of(ink));
        double width = graphics.getFontMetrics().stringWidth(text);
        double left = switch (align) {
            case START -> x;
            case MIDDLE -> x - width / 2;
            case END -> x - width;
        };
        graphics.drawString(text, (float) left, (float) y);
    }
}
