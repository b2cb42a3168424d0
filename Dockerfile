# SPDX-License-Identifier: Apache-2.0
# ilot in a container: docker build -t ilot . ; docker run --rm -v "$PWD:/data" ilot run district.laz -o out
# The first stage makes the tarball with a libgdal without GPL parts (docs/packages.md), the second unpacks it and has nothing else.
FROM debian:bookworm-slim AS build
RUN apt-get update \
 && apt-get install -y --no-install-recommends build-essential ca-certificates debhelper dpkg-dev git nodejs npm
WORKDIR /build/ilot
COPY tools/setup tools/
COPY viewer/package.json viewer/package-lock.json viewer/
RUN tools/setup
COPY packaging/reduced_gdal.sh packaging/
RUN packaging/reduced_gdal.sh /build/gdal
COPY . .
RUN cmake --preset release -DILOT_BUILD_TESTS=OFF && cmake --build build/release --target ilot \
 && packaging/tarball.py build/release/tools/ilot /build/ilot.tar.gz --gdal /build/gdal \
 && mkdir /build/opt && tar -xf /build/ilot.tar.gz -C /build/opt

FROM debian:bookworm-slim
COPY --from=build /build/opt/ilot /opt/ilot
# Results belong to who asks for them: docker run --user "$(id -u):$(id -g)".
RUN ln -s /opt/ilot/bin/ilot /usr/local/bin/ilot && useradd --create-home ilot
USER ilot
WORKDIR /data
ENTRYPOINT ["ilot"]
CMD ["--help"]
