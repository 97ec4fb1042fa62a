// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.List;
import sim.physics.motion.Body;

/** What is saved, and what comes back. */
public final class Checkpoint {
    private Checkpoint() {}

    /** What is saved of an object. */
    public static byte[] bytes(Object object) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(object);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
        return bytes.toByteArray();
    }

    /** What comes back of an object. */
    @SuppressWarnings("unchecked")
    public static <T> T copy(T object) {
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes(object)))) {
            return (T) in.readObject();
        } catch (IOException | ClassNotFoundException e) {
            throw new AssertionError(e);
        }
    }

    /** Demands that two engines have their bodies at the same places and angles, with the same velocities, bit for bit. */
    public static void assertSameBodies(PhysicsEngine one, PhysicsEngine other) {
        List<Body> a = one.bodies();
        List<Body> b = other.bodies();
        for (int k = 0; k < a.size(); k++) {
            assertThat(b.get(k).getX()).isEqualTo(a.get(k).getX());
            assertThat(b.get(k).getVelocityY()).isEqualTo(a.get(k).getVelocityY());
            assertThat(b.get(k).getAngle()).isEqualTo(a.get(k).getAngle());
        }
    }
}
