// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import java.math.BigDecimal;
import java.math.MathContext;

/** Mass properties of a polygon by Green's formulas in decimal arithmetic: the reference. */
record Exact(BigDecimal area, BigDecimal centroidX, BigDecimal centroidY, BigDecimal unitInertia) {
    private static final MathContext DIGITS = new MathContext(80);

    /** For vertices in either sense. */
    static Exact of(double... xy) {
        BigDecimal twiceArea = BigDecimal.ZERO;
        BigDecimal mx = BigDecimal.ZERO;
        BigDecimal my = BigDecimal.ZERO;
        BigDecimal second = BigDecimal.ZERO;
        for (int k = 0; k < xy.length; k += 2) {
            int next = (k + 2) % xy.length;
            BigDecimal ax = new BigDecimal(xy[k]);
            BigDecimal ay = new BigDecimal(xy[k + 1]);
            BigDecimal bx = new BigDecimal(xy[next]);
            BigDecimal by = new BigDecimal(xy[next + 1]);
            BigDecimal cross = ax.multiply(by).subtract(ay.multiply(bx));
            twiceArea = twiceArea.add(cross);
            mx = mx.add(cross.multiply(ax.add(bx)));
            my = my.add(cross.multiply(ay.add(by)));
            BigDecimal squares = ax.multiply(ax.add(bx)).add(bx.multiply(bx));
            squares = squares.add(ay.multiply(ay.add(by))).add(by.multiply(by));
            second = second.add(cross.multiply(squares));
        }
        BigDecimal cx = mx.divide(twiceArea.multiply(BigDecimal.valueOf(3)), DIGITS);
        BigDecimal cy = my.divide(twiceArea.multiply(BigDecimal.valueOf(3)), DIGITS);
        BigDecimal unit = second.divide(twiceArea.multiply(BigDecimal.valueOf(6)), DIGITS);
        unit = unit.subtract(cx.multiply(cx)).subtract(cy.multiply(cy));
        return new Exact(twiceArea.abs().divide(BigDecimal.valueOf(2), DIGITS), cx, cy, unit);
    }

    /** Relative error of a value. */
    static double error(double value, BigDecimal exact) {
        return new BigDecimal(value).subtract(exact).divide(exact, DIGITS).abs().doubleValue();
    }
}
