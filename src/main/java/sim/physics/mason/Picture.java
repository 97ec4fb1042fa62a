// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.util.Objects;
import java.util.function.Function;
import javax.imageio.ImageIO;
import sim.physics.PhysicsEngine;
import sim.physics.internal.Check;
import sim.physics.motion.Body;
import sim.portrayal.DrawInfo2D;

/** Draws an engine's bodies without a display, for runs on machines that have none. */
public final class Picture {
    private final double x;
    private final double y;
    private final double width;
    private final double height;
    private final double scale;
    private final Color background;
    private final Function<Body, Color> colors;

    /**
     * Creates a kind of picture.
     *
     * @param x left edge of the part of the world to draw
     * @param y upper edge of that part
     * @param width width of that part
     * @param height height of that part
     * @param scale pixels per unit of length
     * @param background colour of the background
     * @param colors function that gives the colour of each body, or null for one that is not drawn
     * @throws IllegalArgumentException if a number is not finite, or a size or the scale not greater than 0
     */
    public Picture(
            double x,
            double y,
            double width,
            double height,
            double scale,
            Color background,
            Function<Body, Color> colors) {
        this.x = Check.finite("x", x);
        this.y = Check.finite("y", y);
        this.width = Check.positive("width", width);
        this.height = Check.positive("height", height);
        this.scale = Check.positive("scale", scale);
        this.background = Objects.requireNonNull(background, "background");
        this.colors = Objects.requireNonNull(colors, "colors");
    }

    /**
     * Draws the bodies where they are.
     *
     * @param engine the engine that has the bodies
     * @return the image
     */
    public BufferedImage draw(PhysicsEngine engine) {
        return draw(engine, new EnginePortrayal2D[0]);
    }

    /**
     * Draws the bodies where they are, and over them what layers of a display show, such as a {@link JointsPortrayal2D} or a
     * {@link ContactsPortrayal2D}. The layers' fields are set to the engine.
     *
     * @param engine the engine that has the bodies
     * @param layers any number of layers, the last one on top; the size of the world that they were made with does not matter
     * @return the image
     */
    public BufferedImage draw(PhysicsEngine engine, EnginePortrayal2D... layers) {
        Objects.requireNonNull(engine, "engine");
        Objects.requireNonNull(layers, "layers");
        int pixelsX = (int) Math.ceil(width * scale);
        int pixelsY = (int) Math.ceil(height * scale);
        BufferedImage image = new BufferedImage(pixelsX, pixelsY, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setColor(background);
        graphics.fillRect(0, 0, pixelsX, pixelsY);
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        for (Body body : engine.bodies()) {
            Color color = colors.apply(body);
            if (color != null) {
                AffineTransform place = AffineTransform.getScaleInstance(scale, scale);
                place.translate(body.getX() - x, body.getY() - y);
                place.rotate(body.getAngle());
                graphics.setColor(color);
                graphics.fill(place.createTransformedShape(AwtShapes.of(body.getShape())));
            }
        }
        for (EnginePortrayal2D layer : layers) {
            Rectangle2D.Double all = new Rectangle2D.Double(-x * scale, -y * scale, layer.getWidth() * scale, layer.getHeight() * scale);
            layer.setField(engine);
            layer.draw(engine, graphics, new DrawInfo2D(null, layer, all, new Rectangle2D.Double(0, 0, pixelsX, pixelsY)));
        }
        graphics.dispose();
        return image;
    }

    /**
     * Draws the bodies into a PNG file.
     *
     * @param engine the engine that has the bodies
     * @param file file to write
     * @throws IOException if the file cannot be written
     */
    public void write(PhysicsEngine engine, File file) throws IOException {
        write(engine, file, new EnginePortrayal2D[0]);
    }

    /**
     * Draws the bodies into a PNG file, with layers over them.
     *
     * @param engine the engine that has the bodies
     * @param file file to write
     * @param layers layers to draw over the bodies
     * @throws IOException if the file cannot be written
     */
    public void write(PhysicsEngine engine, File file, EnginePortrayal2D... layers) throws IOException {
        Objects.requireNonNull(file, "file");
        if (!ImageIO.write(draw(engine, layers), "png", file)) {
            throw new IOException("no writer for PNG files is at hand to write " + file);
        }
    }
}
