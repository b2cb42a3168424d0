# SPDX-License-Identifier: Apache-2.0
# ilot in a container: docker build -t ilot . ; docker run --rm -v "$PWD:/data" ilot run district.laz -o out
# The first stage makes the Debian package (docs/packages.md), the second has what that needs and nothing of the build.
FROM debian:bookworm-slim AS build
RUN apt-get update \
 && apt-get install -y --no-install-recommends build-essential ca-certificates nodejs npm
WORKDIR /build/ilot
COPY debian/control debian/changelog debian/
RUN apt-get build-dep -y --no-install-recommends ./
# What reports show in 3D; apart from the sources, so that it is fetched again only when the lock changes.
COPY viewer/package.json viewer/package-lock.json viewer/
RUN npm ci --prefix viewer --no-fund --no-audit
COPY . .
RUN dpkg-buildpackage -b -us -uc

FROM debian:bookworm-slim
COPY --from=build /build/ilot_*.deb /tmp/
RUN apt-get update \
 && apt-get install -y --no-install-recommends /tmp/ilot_*.deb \
 && rm -rf /var/lib/apt/lists/* /tmp/*.deb
# Results belong to who asks for them: docker run --user "$(id -u):$(id -g)".
RUN useradd --create-home ilot
USER ilot
WORKDIR /data
ENTRYPOINT ["ilot"]
CMD ["--help"]
