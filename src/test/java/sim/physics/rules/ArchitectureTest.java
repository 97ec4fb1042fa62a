// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.rules;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.Architectures.layeredArchitecture;
import static com.tngtech.archunit.library.GeneralCodingRules.NO_CLASSES_SHOULD_ACCESS_STANDARD_STREAMS;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import org.junit.jupiter.api.Test;

/** The packages are the write-up's chapters, in layers and without cycles; and what is never done. */
class ArchitectureTest {
    private static final JavaClasses PRODUCT = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .importPackages("sim.physics");

    @Test
    void chaptersUseOnlyChaptersBelow() {
        layeredArchitecture()
                .consideringOnlyDependenciesInLayers()
                .layer("internal").definedBy("sim.physics.internal")
                .layer("matrix").definedBy("sim.physics.matrix")
                .layer("shape").definedBy("sim.physics.shape")
                .layer("motion").definedBy("sim.physics.motion")
                .layer("tree").definedBy("sim.physics.constraint.tree")
                .layer("constraint").definedBy("sim.physics.constraint")
                .layer("broad").definedBy("sim.physics.collision.broad")
                .layer("narrow").definedBy("sim.physics.collision.narrow")
                .layer("collision").definedBy("sim.physics.collision")
                .layer("lasting").definedBy("sim.physics.response.lasting")
                .layer("response").definedBy("sim.physics.response")
                .layer("stepping").definedBy("sim.physics.stepping")
                .layer("query").definedBy("sim.physics.query")
                .layer("engine").definedBy("sim.physics")
                .layer("mason").definedBy("sim.physics.mason")
                .whereLayer("mason").mayNotBeAccessedByAnyLayer()
                .whereLayer("engine").mayOnlyBeAccessedByLayers("mason")
                .whereLayer("stepping").mayOnlyBeAccessedByLayers("engine")
                .whereLayer("response").mayOnlyBeAccessedByLayers("engine", "mason", "stepping")
                .whereLayer("lasting").mayOnlyBeAccessedByLayers("engine", "response")
                .whereLayer("collision").mayOnlyBeAccessedByLayers("engine", "response", "lasting", "stepping")
                .whereLayer("narrow").mayOnlyBeAccessedByLayers("engine", "response", "lasting", "collision")
                .whereLayer("broad").mayOnlyBeAccessedByLayers("engine", "response", "lasting", "collision", "narrow", "stepping")
                .whereLayer("motion")
                .mayOnlyBeAccessedByLayers(
                        "engine", "response", "lasting", "constraint", "tree", "collision", "narrow", "mason", "query", "stepping")
                .whereLayer("query").mayOnlyBeAccessedByLayers("engine")
                .whereLayer("constraint").mayOnlyBeAccessedByLayers("engine", "mason", "stepping")
                .whereLayer("tree").mayOnlyBeAccessedByLayers("constraint")
                .whereLayer("matrix").mayOnlyBeAccessedByLayers("motion", "response", "lasting", "constraint", "tree", "stepping")
                .check(PRODUCT);
    }

    @Test
    void packagesHaveNoCycles() {
        slices().matching("sim.physics.(**)").should().beFreeOfCycles().check(PRODUCT);
    }

    @Test
    void onlyTheBorderKnowsMason() {
        noClasses()
                .that().resideOutsideOfPackages("sim.physics", "sim.physics.mason")
                .should().dependOnClassesThat()
                .resideInAnyPackage("sim.engine..", "sim.display..", "sim.portrayal..", "sim.field..", "sim.util..", "ec..")
                .check(PRODUCT);
        noClasses()
                .that().resideOutsideOfPackage("sim.physics.mason")
                .should().dependOnClassesThat().resideInAnyPackage("java.awt..", "javax.swing..")
                .check(PRODUCT);
    }

    @Test
    void schedulingThatChangedBetweenVersionsOfMasonIsNotUsed() {
        noClasses()
                .should().callMethodWhere(new com.tngtech.archunit.base.DescribedPredicate<>("scheduleRepeating") {
                    @Override
                    public boolean test(com.tngtech.archunit.core.domain.JavaMethodCall call) {
                        return call.getName().equals("scheduleRepeating");
                    }
                })
                .check(PRODUCT);
    }

    @Test
    void nothingIsPrintedAndNothingIsStatic() {
        NO_CLASSES_SHOULD_ACCESS_STANDARD_STREAMS.check(PRODUCT);
        fields()
                .that().areStatic()
                .and().doNotHaveModifier(JavaModifier.SYNTHETIC)
                .should().beFinal()
                .check(PRODUCT);
    }

    @Test
    void sinesComeFromOnePlace() {
        for (String name : new String[] {"sin", "cos", "tan", "atan2", "exp", "pow", "log", "hypot", "random"}) {
            noClasses()
                    .should().callMethod(Math.class, name, double.class)
                    .orShould().callMethod(Math.class, name, double.class, double.class)
                    .orShould().callMethod(Math.class, name)
                    .check(PRODUCT);
        }
    }
}
